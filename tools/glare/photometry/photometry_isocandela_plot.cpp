#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include "glare/base/error.h"
#include "info_text.h"
#include "photometry/contours.h"
#include "photometry/photometry_plot.h"
#include "photometry/round_numbers.h"
#include "svg.h"

namespace glare::tool {

namespace {

constexpr double kPageWidth = 880, kLeft = 70, kTop = 62, kMostWidth = 690, kLegendWidth = 110;
constexpr int kMostNodes = 400;  ///< Each way; a finer grid is thinned out to that.
constexpr int kFewNodes = 120;   ///< And a coarser one made as fine as that, or nearly.

struct Range {
  double lo, hi;
  double length() const { return hi - lo; }
};

/// The drawn part of the directions, and where it lies on the page.
struct View {
  Range h, v;
  double width = 0, height = 0;

  double left_of(double h_deg) const { return kLeft + width * (h_deg - h.lo) / h.length(); }
  double top_of(double v_deg) const { return kTop + height * (v.hi - v_deg) / v.length(); }
};

/// The grid that is drawn.
struct Grid {
  std::vector<double> h_deg, v_deg;
  Image<float> candela;
};

float peak_of(const LuminousIntensityDistribution& distribution) {
  const auto values = distribution.candela().values();
  return *std::max_element(values.begin(), values.end());
}

/// Where the intensity is a fiftieth of the peak or more; all directions, where all are dark.
std::array<Range, 2> bright_part(const LuminousIntensityDistribution& d) {
  const Image<float>& candela = d.candela();
  const double least = peak_of(d) / 50;
  std::array<Range, 2> part{Range{HUGE_VAL, -HUGE_VAL}, Range{HUGE_VAL, -HUGE_VAL}};
  for (int j = 0; j < candela.height(); ++j)
    for (int i = 0; i < candela.width(); ++i) {
      if (candela(i, j) < least) continue;
      const double angles[] = {d.horizontal_deg()[static_cast<std::size_t>(i)],
                               d.vertical_deg()[static_cast<std::size_t>(j)]};
      for (const std::size_t axis : {0u, 1u}) {
        part[axis].lo = std::min(part[axis].lo, angles[axis]);
        part[axis].hi = std::max(part[axis].hi, angles[axis]);
      }
    }
  return part;
}

/// A range with some room around it, of round numbers, within the measured one.
Range with_room(Range range, double length, Range measured) {
  const double middle = (range.lo + range.hi) / 2,
               half = std::max(range.length() * 1.15, length) / 2;
  const double step = round_step(2 * half, 10);
  return {std::max(std::floor((middle - half) / step) * step, measured.lo),
          std::min(std::ceil((middle + half) / step) * step, measured.hi)};
}

Range checked(const std::array<double, 2>& asked, Range measured, const char* name) {
  const auto [lo, hi] = asked;
  if (lo >= measured.lo && hi <= measured.hi && lo < hi) return {lo, hi};
  throw OptionError("the plot's " + std::string(name) + " goes from " + number(lo) + " to " +
                    number(hi) + " degrees; expected an ascending range within " +
                    number(measured.lo) + " to " + number(measured.hi));
}

View view_of(const LuminousIntensityDistribution& d, const PlotRange& range) {
  const Range h_measured{d.horizontal_deg().front(), d.horizontal_deg().back()};
  const Range v_measured{d.vertical_deg().front(), d.vertical_deg().back()};
  auto [h, v] = bright_part(d);
  if (h.lo < 0 && h.hi > 0) h = {std::min(h.lo, -h.hi), std::max(-h.lo, h.hi)};
  const double least = std::min({1.0, h_measured.length(), v_measured.length()});
  View view{with_room(h, std::max(least, 0.5 * v.length()), h_measured),
            with_room(v, std::max(least, 0.36 * h.length()), v_measured)};
  if (range.h_deg) view.h = checked(*range.h_deg, h_measured, "H");
  if (range.v_deg) view.v = checked(*range.v_deg, v_measured, "V");
  view.width = kMostWidth;
  view.height = std::clamp(kMostWidth * view.v.length() / view.h.length(), 200.0, 690.0);
  if (view.height == 690)
    view.width = std::clamp(690 * view.h.length() / view.v.length(), 200.0, kMostWidth);
  return view;
}

/// The angles, and equal steps between them where they are few.
std::vector<double> subdivided(const std::vector<double>& angles) {
  const auto parts = std::max(1, kFewNodes / static_cast<int>(angles.size()));
  std::vector<double> result;
  for (std::size_t k = 0; k + 1 < angles.size(); ++k)
    for (int part = 0; part < parts; ++part)
      result.push_back(angles[k] + (angles[k + 1] - angles[k]) * part / parts);
  result.push_back(angles.back());
  return result;
}

/// The measured angles about a range, subdivided, or as many equal steps as are drawn.
std::vector<double> nodes(const std::vector<double>& measured, Range range) {
  auto first = std::upper_bound(measured.begin(), measured.end(), range.lo);
  auto last = std::lower_bound(measured.begin(), measured.end(), range.hi);
  if (first != measured.begin()) --first;
  if (last != measured.end()) ++last;
  if (last - first <= kMostNodes) return subdivided({first, last});
  std::vector<double> equal(kMostNodes);
  for (int k = 0; k < kMostNodes; ++k)
    equal[static_cast<std::size_t>(k)] = range.lo + range.length() * k / (kMostNodes - 1);
  return equal;
}

Grid grid_of(const LuminousIntensityDistribution& d, const View& view) {
  Grid grid{nodes(d.horizontal_deg(), view.h), nodes(d.vertical_deg(), view.v), {}};
  grid.candela =
      Image<float>(static_cast<int>(grid.h_deg.size()), static_cast<int>(grid.v_deg.size()));
  for (int j = 0; j < grid.candela.height(); ++j)
    for (int i = 0; i < grid.candela.width(); ++i)
      grid.candela(i, j) = static_cast<float>(
          d(grid.h_deg[static_cast<std::size_t>(i)], grid.v_deg[static_cast<std::size_t>(j)]));
  return grid;
}

/// From blue, the dimmest, to dark red.
std::string color_of(std::size_t k, std::size_t count) {
  constexpr int kColors[][3] = {{59, 76, 192}, {32, 134, 178}, {30, 150, 110}, {120, 150, 30},
                                {200, 130, 0}, {214, 72, 30},  {140, 15, 50}};
  const double place =
      count > 1 ? 6.0 * static_cast<double>(count - 1 - k) / static_cast<double>(count - 1) : 6.0;
  const int lower = std::min(static_cast<int>(place), 5);
  char text[8];
  const auto mixed = [&](int channel) {
    const int a = kColors[lower][channel], b = kColors[lower + 1][channel];
    return static_cast<unsigned>(std::lround(a + (place - lower) * (b - a)));
  };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", mixed(0) & 255u, mixed(1) & 255u,
                mixed(2) & 255u);
  return text;
}

std::string path_of(const ContourLine& contour, const View& view) {
  std::string path = "M";
  for (const auto& [h, v] : contour)
    path += svg_number(view.left_of(h)) + "," + svg_number(view.top_of(v)) + " ";
  return path;
}

/// Where labels are, so that none covers another.
class Labels {
 public:
  explicit Labels(const View& view) : view_(view) {}

  /// A label at the contours' outermost place that is free; nothing where none is, or where it
  /// would hide much of them.
  std::string on(const std::vector<ContourLine>& contours, const std::string& text,
                 const std::string& color) {
    const std::array<std::array<double, 2>, 4> directions{{{1, 0}, {-1, 0}, {0, -1}, {0, 1}}};
    const double half = 3.6 * static_cast<double>(text.size()) + 2;
    const double reach =
        outermost(contours, directions[0])[0] - outermost(contours, directions[1])[0];
    if (reach < 4 * half) return {};
    for (const auto& direction : directions) {
      const std::array<double, 2> place = outermost(contours, direction);
      if (!free(place, half)) continue;
      taken_.push_back({place[0], place[1], half});
      return svg_label(place[0], place[1] + 4, "text-anchor=\"middle\" font-size=\"11\"", color,
                       text);
    }
    return {};
  }

 private:
  std::array<double, 2> outermost(const std::vector<ContourLine>& contours,
                                  const std::array<double, 2>& direction) const {
    std::array<double, 2> best{};
    double furthest = -HUGE_VAL;
    for (const ContourLine& contour : contours)
      for (const auto& [h, v] : contour) {
        const double reach = direction[0] * h + direction[1] * v;
        if (reach <= furthest || h < view_.h.lo || h > view_.h.hi || v < view_.v.lo ||
            v > view_.v.hi)
          continue;
        furthest = reach;
        best = {view_.left_of(h), view_.top_of(v)};
      }
    return best;
  }

  bool free(const std::array<double, 2>& place, double half) const {
    if (place[0] - half < kLeft || place[0] + half > kLeft + view_.width) return false;
    if (place[1] - 8 < kTop || place[1] + 8 > kTop + view_.height) return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const std::array<double, 3>& other) {
      return std::abs(other[0] - place[0]) < half + other[2] && std::abs(other[1] - place[1]) < 14;
    });
  }

  const View& view_;
  std::vector<std::array<double, 3>> taken_;
};

std::string contours_as_svg(const Grid& grid, const View& view, const std::vector<double>& levels) {
  std::string paths, texts, legend;
  Labels labels(view);
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const std::string color = color_of(k, levels.size()), text = number(levels[k], 9);
    const auto contours = contour_lines(grid.h_deg, grid.v_deg, grid.candela, levels[k]);
    for (const ContourLine& contour : contours)
      paths += "<path fill=\"none\" stroke=\"" + color + "\" stroke-width=\"1.4\" d=\"" +
               path_of(contour, view) + "\"/>\n";
    texts += labels.on(contours, text, color);
    const double x = kLeft + view.width + 22, y = kTop + 30 + 18 * static_cast<double>(k);
    legend += svg_line(x, y - 4, x + 22, y - 4, "stroke=\"" + color + "\" stroke-width=\"2\"") +
              svg_text(x + 30, y, "font-size=\"12\"", text);
  }
  return "<clipPath id=\"plot\"><rect x=\"" + svg_number(kLeft) + "\" y=\"" + svg_number(kTop) +
         "\" width=\"" + svg_number(view.width) + "\" height=\"" + svg_number(view.height) +
         "\"/></clipPath>\n<g clip-path=\"url(#plot)\">\n" + paths + "</g>\n" + texts +
         svg_text(kLeft + view.width + 22, kTop + 10, "font-size=\"12\"", "candela") + legend;
}

std::string axes_as_svg(const View& view) {
  const double bottom = kTop + view.height, right = kLeft + view.width;
  const auto stroke = [](double at) {
    return std::string(at == 0 ? "stroke=\"#606060\" stroke-dasharray=\"6 3\""
                               : "stroke=\"#dcdcdc\"");
  };
  std::string text;
  const double h_step = round_step(view.h.length(), 14);
  for (double k = std::ceil(view.h.lo / h_step - 1e-9); k * h_step <= view.h.hi * (1 + 1e-9); ++k) {
    const double x = view.left_of(k * h_step);
    text += svg_line(x, kTop, x, bottom, stroke(k)) +
            svg_text(x, bottom + 18, "text-anchor=\"middle\"", number(k * h_step + 0.0));
  }
  const double v_step =
      round_step(view.v.length(), std::max(4, static_cast<int>(view.height / 40)));
  for (double k = std::ceil(view.v.lo / v_step - 1e-9); k * v_step <= view.v.hi + 1e-9; ++k) {
    const double y = view.top_of(k * v_step);
    text += svg_line(kLeft, y, right, y, stroke(k)) +
            svg_text(kLeft - 8, y + 5, "text-anchor=\"end\"", number(k * v_step + 0.0));
  }
  text += "<rect x=\"" + svg_number(kLeft) + "\" y=\"" + svg_number(kTop) + "\" width=\"" +
          svg_number(view.width) + "\" height=\"" + svg_number(view.height) +
          "\" fill=\"none\" stroke=\"#404040\"/>\n";
  text += svg_text((kLeft + right) / 2, bottom + 40, "text-anchor=\"middle\"",
                   "H, degrees, right positive");
  return text + svg_text(0, 0,
                         "text-anchor=\"middle\" transform=\"translate(22 " +
                             svg_number((kTop + bottom) / 2) + ") rotate(-90)\"",
                         "V, degrees, up positive");
}

}  // namespace

std::string isocandela_plot_svg(const LuminousIntensityDistribution& distribution,
                                const std::string& title, const PlotRange& range) {
  const View view = view_of(distribution, range);
  const double peak = peak_of(distribution);
  const auto levels = peak > 0 ? round_numbers(peak / 1000, peak) : std::vector<double>();
  const double height = std::max(view.height, 30 + 18.0 * static_cast<double>(levels.size()));
  return svg_start(std::min(kPageWidth, kLeft + view.width + kLegendWidth + 10), kTop + height + 56,
                   title) +
         svg_text(kLeft, 30, "font-size=\"16\"", escaped(shortened(title, 95))) +
         svg_text(kLeft, 50, "font-size=\"12\" fill=\"#606060\"",
                  "luminous intensity of type " +
                      std::string(distribution.type() == PhotometricType::b ? "B" : "A") +
                      ", as seen from the lamp; peak " + number(peak) + " cd") +
         axes_as_svg(view) + contours_as_svg(grid_of(distribution, view), view, levels) +
         "</svg>\n";
}

std::string photometry_plot_svg(const LuminousIntensityDistribution& distribution,
                                const std::string& title, const PlotRange& range) {
  if (distribution.type() != PhotometricType::c)
    return isocandela_plot_svg(distribution, title, range);
  if (range.h_deg || range.v_deg)
    throw OptionError("the plot of type C is polar; a range of H and V is for type A and B");
  return polar_plot_svg(distribution, title);
}

}  // namespace glare::tool
