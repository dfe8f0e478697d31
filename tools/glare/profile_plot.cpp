#include "profile_plot.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <system_error>

#include "file_names.h"
#include "glare/base/error.h"
#include "glare/base/units.h"
#include "glare/io/atomic_file.h"

namespace glare::tool {

namespace {

constexpr double kWidth = 860, kHeight = 600;
constexpr double kLeft = 90, kRight = 830, kTop = 60, kBottom = 530;
constexpr const char* kProfileColor = "#c2410c";
constexpr const char* kCurveColor = "#1d4ed8";

struct Point {
  double angle_deg, per_steradian;
};

/// Whole decades: from 10^first to 10^last.
struct Decades {
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();

  bool empty() const { return last < first; }
  void include(double value) {
    first = std::min(first, static_cast<int>(std::floor(std::log10(value))));
    last = std::max({last, static_cast<int>(std::ceil(std::log10(value))), first + 1});
  }
  double share(double value) const { return (std::log10(value) - first) / (last - first); }
  /// Decades from label to label, so that there are ten labels at most.
  int step() const { return (last - first + 9) / 10; }
};

struct Axes {
  Decades x, y;

  double left_of(double angle_deg) const { return kLeft + (kRight - kLeft) * x.share(angle_deg); }
  double top_of(double value) const { return kBottom - (kBottom - kTop) * y.share(value); }
};

std::string text_of(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::fixed, 2).ptr;
  return {text, end};
}

/// How many bytes the valid UTF-8 character at `at` has, of those that XML allows; 0 for none.
std::size_t utf8_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0u;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead >= ' ' && lead != 0x7F ? 1 : 0;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
  unsigned code = lead & (0x7Fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(k) & 0x3F);
  }
  constexpr unsigned kFirstOfLength[] = {0, 0, 0xA0, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code < 0xE000, no_character = (code & 0xFFFE) == 0xFFFE;
  if (code < kFirstOfLength[length] || code > 0x10FFFF || surrogate || no_character) return 0;
  return length;
}

/// For XML: markup escaped, and a question mark for each byte that is no character of it, so that
/// no text of a file's can break the drawing.
std::string escaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const auto c = static_cast<unsigned char>(text[i]);
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (length == 0)
      result += '?';
    else
      result.append(text, i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

/// A text cut to what the page has room for.
std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string text_at(double x, double y, const std::string& attributes, const std::string& content) {
  return "<text x=\"" + text_of(x) + "\" y=\"" + text_of(y) + "\" " + attributes + ">" + content +
         "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes) {
  return "<line x1=\"" + text_of(x1) + "\" y1=\"" + text_of(y1) + "\" x2=\"" + text_of(x2) +
         "\" y2=\"" + text_of(y2) + "\" " + attributes + "/>\n";
}

std::string power_of_ten(int exponent) {
  return "10<tspan dy=\"-6\" font-size=\"10\">" + std::to_string(exponent) + "</tspan>";
}

/// The place of a ring's mean, for light that falls as the third power of the angle, where the
/// mean over the ring is the value at (a b (a + b) / 2)^(1/3); the first ring's is the circle that
/// halves its area. Nothing where that is no direction, or dark.
std::optional<Point> point_of(const ProfileRing& ring) {
  const double a = ring.inner_deg * kRadPerDeg, b = ring.outer_deg * kRadPerDeg;
  const double sine = a > 0 ? std::cbrt(a * b * (a + b) / 2) : b / std::sqrt(2.0);
  if (!(sine > 0 && sine < 1 && ring.mean_per_steradian > 0)) return std::nullopt;
  if (!std::isnormal(sine) || !std::isnormal(ring.mean_per_steradian)) return std::nullopt;
  return Point{std::asin(sine) / kRadPerDeg, ring.mean_per_steradian};
}

std::vector<Point> profile_points(const std::vector<ProfileRing>& rings) {
  std::vector<Point> points;
  for (const ProfileRing& ring : rings)
    if (const auto point = point_of(ring)) points.push_back(*point);
  return points;
}

/// The equation from 0.1 degrees to the profile's end; nothing where that is nearer.
std::vector<Point> curve_points(const Straylight& eye, double last_deg) {
  std::vector<Point> points;
  const double steps = std::ceil(40 * std::log10(last_deg / kSmallestCieAngle_deg));
  for (int i = 0; i <= steps && steps > 0; ++i) {
    const double angle =
        kSmallestCieAngle_deg * std::pow(last_deg / kSmallestCieAngle_deg, i / steps);
    points.push_back({angle, cie_general_glare(angle, eye.age_years, eye.pigment)});
  }
  return points;
}

std::string polyline(const std::vector<Point>& points, const Axes& axes,
                     const std::string& attributes) {
  std::string text = "<polyline fill=\"none\" " + attributes + " points=\"";
  for (const Point& p : points)
    text += text_of(axes.left_of(p.angle_deg)) + "," + text_of(axes.top_of(p.per_steradian)) + " ";
  return text + "\"/>\n";
}

std::string grid_as_svg(const Axes& axes) {
  const std::string thin = "stroke=\"#d4d4d4\" stroke-width=\"1\"";
  std::string text;
  for (int k = axes.x.first; k <= axes.x.last; k += axes.x.step()) {
    const double x = axes.left_of(std::pow(10.0, k));
    text += line(x, kTop, x, kBottom, thin) +
            text_at(x, kBottom + 22, "text-anchor=\"middle\"", power_of_ten(k));
  }
  for (int k = axes.y.first; k <= axes.y.last; k += axes.y.step()) {
    const double y = axes.top_of(std::pow(10.0, k));
    text += line(kLeft, y, kRight, y, thin) +
            text_at(kLeft - 10, y + 5, "text-anchor=\"end\"", power_of_ten(k));
  }
  return text;
}

std::string small_ticks_as_svg(const Axes& axes) {
  std::string text;
  const std::string stroke = "stroke=\"#404040\" stroke-width=\"1\"";
  for (int k = axes.x.first; k < axes.x.last && axes.x.step() == 1; ++k)
    for (int digit = 2; digit < 10; ++digit) {
      const double x = axes.left_of(digit * std::pow(10.0, k));
      text += line(x, kBottom, x, kBottom - 5, stroke);
    }
  for (int k = axes.y.first; k < axes.y.last && axes.y.step() == 1; ++k)
    for (int digit = 2; digit < 10; ++digit) {
      const double y = axes.top_of(digit * std::pow(10.0, k));
      text += line(kLeft, y, kLeft + 5, y, stroke);
    }
  return text;
}

std::string frame_as_svg(const ProfilePlot& plot) {
  const std::string middle = "text-anchor=\"middle\"";
  return "<rect x=\"" + text_of(kLeft) + "\" y=\"" + text_of(kTop) + "\" width=\"" +
         text_of(kRight - kLeft) + "\" height=\"" + text_of(kBottom - kTop) +
         "\" fill=\"none\" stroke=\"#404040\"/>\n" +
         text_at((kLeft + kRight) / 2, 34, middle + " font-size=\"16\"",
                 escaped(shortened(plot.title, 100))) +
         text_at((kLeft + kRight) / 2, kBottom + 50, middle, "angle from the axis, degrees") +
         text_at(0, 0,
                 middle + " transform=\"translate(26 " + text_of((kTop + kBottom) / 2) +
                     ") rotate(-90)\"",
                 "luminance per illuminance at the eye, (cd/m²)/lx = 1/sr");
}

std::string legend_as_svg(const ProfilePlot& plot, bool has_curve) {
  const double x = kRight - 400, y = kTop + 24;
  const auto entry = [&](double top, const std::string& color, const std::string& label) {
    return line(x, top - 4, x + 30, top - 4, "stroke=\"" + color + "\" stroke-width=\"2\"") +
           text_at(x + 38, top, "font-size=\"12\"", label);
  };
  std::string text = "<rect x=\"" + text_of(x - 10) + "\" y=\"" + text_of(y - 18) +
                     "\" width=\"400\" height=\"" + (has_curve ? "48" : "26") +
                     "\" fill=\"white\" stroke=\"#d4d4d4\"/>\n";
  text += entry(y, kProfileColor, "template, mean around the axis");
  if (has_curve) text += entry(y + 22, kCurveColor, escaped(shortened(plot.curve_label, 60)));
  return text;
}

std::string dots_as_svg(const std::vector<Point>& points, const Axes& axes) {
  std::string text;
  for (const Point& p : points)
    text += "<circle cx=\"" + text_of(axes.left_of(p.angle_deg)) + "\" cy=\"" +
            text_of(axes.top_of(p.per_steradian)) + "\" r=\"2.5\" fill=\"" + kProfileColor +
            "\"/>\n";
  return text;
}

Axes axes_of(const std::vector<Point>& profile, const std::vector<Point>& curve) {
  Axes axes;
  for (const std::vector<Point>& points : {profile, curve})
    for (const Point& p : points) {
      axes.x.include(p.angle_deg);
      axes.y.include(p.per_steradian);
    }
  if (axes.x.empty()) axes = {{-2, 2}, {-2, 8}};
  return axes;
}

}  // namespace

std::string profile_plot_svg(const ProfilePlot& plot) {
  const std::vector<Point> profile = profile_points(plot.rings);
  const auto curve =
      profile.empty() ? std::vector<Point>() : curve_points(plot.eye, profile.back().angle_deg);
  const Axes axes = axes_of(profile, curve);
  const std::string size = text_of(kWidth) + "\" height=\"" + text_of(kHeight);
  std::string svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"" +
      size + "\" viewBox=\"0 0 " + text_of(kWidth) + " " + text_of(kHeight) +
      "\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#202020\">\n"
      "<title>" +
      escaped(plot.title) + "</title>\n<rect width=\"" + size + "\" fill=\"white\"/>\n";
  svg += grid_as_svg(axes) + small_ticks_as_svg(axes) + frame_as_svg(plot);
  svg +=
      polyline(profile, axes, std::string("stroke=\"") + kProfileColor + "\" stroke-width=\"1.5\"");
  svg += dots_as_svg(profile, axes);
  if (!curve.empty())
    svg += polyline(
        curve, axes,
        std::string("stroke=\"") + kCurveColor + "\" stroke-width=\"2\" stroke-dasharray=\"7 4\"");
  return svg + legend_as_svg(plot, !curve.empty()) + "</svg>\n";
}

void require_plot_writable(const std::string& plot, const std::string& input) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (canonical(plot) == canonical(input) || fs::equivalent(plot, input, error))
    throw OptionError("the output " + plot + " is an input too");
  if (ending_of(plot) != ".svg")
    throw OptionError("--plot " + plot + ": expected a name that ends in .svg");
  require_writable(plot);
}

}  // namespace glare::tool
