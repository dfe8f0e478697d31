#include "info/profile_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "glare/base/units.h"
#include "svg.h"

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
    text += svg_number(axes.left_of(p.angle_deg)) + "," + svg_number(axes.top_of(p.per_steradian)) +
            " ";
  return text + "\"/>\n";
}

std::string grid_as_svg(const Axes& axes) {
  const std::string thin = "stroke=\"#d4d4d4\" stroke-width=\"1\"";
  std::string text;
  for (int k = axes.x.first; k <= axes.x.last; k += axes.x.step()) {
    const double x = axes.left_of(std::pow(10.0, k));
    text += svg_line(x, kTop, x, kBottom, thin) +
            svg_text(x, kBottom + 22, "text-anchor=\"middle\"", power_of_ten(k));
  }
  for (int k = axes.y.first; k <= axes.y.last; k += axes.y.step()) {
    const double y = axes.top_of(std::pow(10.0, k));
    text += svg_line(kLeft, y, kRight, y, thin) +
            svg_text(kLeft - 10, y + 5, "text-anchor=\"end\"", power_of_ten(k));
  }
  return text;
}

std::string small_ticks_as_svg(const Axes& axes) {
  std::string text;
  const std::string stroke = "stroke=\"#404040\" stroke-width=\"1\"";
  for (int k = axes.x.first; k < axes.x.last && axes.x.step() == 1; ++k)
    for (int digit = 2; digit < 10; ++digit) {
      const double x = axes.left_of(digit * std::pow(10.0, k));
      text += svg_line(x, kBottom, x, kBottom - 5, stroke);
    }
  for (int k = axes.y.first; k < axes.y.last && axes.y.step() == 1; ++k)
    for (int digit = 2; digit < 10; ++digit) {
      const double y = axes.top_of(digit * std::pow(10.0, k));
      text += svg_line(kLeft, y, kLeft + 5, y, stroke);
    }
  return text;
}

std::string frame_as_svg(const ProfilePlot& plot) {
  const std::string middle = "text-anchor=\"middle\"";
  return "<rect x=\"" + svg_number(kLeft) + "\" y=\"" + svg_number(kTop) + "\" width=\"" +
         svg_number(kRight - kLeft) + "\" height=\"" + svg_number(kBottom - kTop) +
         "\" fill=\"none\" stroke=\"#404040\"/>\n" +
         svg_text((kLeft + kRight) / 2, 34, middle + " font-size=\"16\"",
                  escaped(shortened(plot.title, 100))) +
         svg_text((kLeft + kRight) / 2, kBottom + 50, middle, "angle from the axis, degrees") +
         svg_text(0, 0,
                  middle + " transform=\"translate(26 " + svg_number((kTop + kBottom) / 2) +
                      ") rotate(-90)\"",
                  "luminance per illuminance at the eye, (cd/m²)/lx = 1/sr");
}

std::string legend_as_svg(const ProfilePlot& plot, bool has_curve) {
  const double x = kRight - 400, y = kTop + 24;
  const auto entry = [&](double top, const std::string& color, const std::string& label) {
    return svg_line(x, top - 4, x + 30, top - 4, "stroke=\"" + color + "\" stroke-width=\"2\"") +
           svg_text(x + 38, top, "font-size=\"12\"", label);
  };
  std::string text = "<rect x=\"" + svg_number(x - 10) + "\" y=\"" + svg_number(y - 18) +
                     "\" width=\"400\" height=\"" + (has_curve ? "48" : "26") +
                     "\" fill=\"white\" stroke=\"#d4d4d4\"/>\n";
  text += entry(y, kProfileColor, "template, mean around the axis");
  if (has_curve) text += entry(y + 22, kCurveColor, escaped(shortened(plot.curve_label, 60)));
  return text;
}

std::string dots_as_svg(const std::vector<Point>& points, const Axes& axes) {
  std::string text;
  for (const Point& p : points)
    text += "<circle cx=\"" + svg_number(axes.left_of(p.angle_deg)) + "\" cy=\"" +
            svg_number(axes.top_of(p.per_steradian)) + "\" r=\"2.5\" fill=\"" + kProfileColor +
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
  std::string svg = svg_start(kWidth, kHeight, plot.title);
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

}  // namespace glare::tool
