#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "glare/base/units.h"
#include "info_text.h"
#include "photometry/photometry_plot.h"
#include "photometry/round_numbers.h"
#include "svg.h"

namespace glare::tool {

namespace {

constexpr double kWidth = 640, kRadius = 240, kTop = 100, kMiddle = kWidth / 2;

struct Curve {
  double c_deg;
  double side;                                ///< 1 to the right, -1 to the left.
  std::vector<std::array<double, 2>> points;  ///< gamma in degrees, candela.
};

/// Where a direction and intensity lie.
struct Polar {
  double center_y, full_candela;

  std::array<double, 2> at(double gamma_deg, double candela, double side) const {
    const double r = kRadius * candela / full_candela, gamma = gamma_deg * kRadPerDeg;
    return {kMiddle + side * r * std::sin(gamma), center_y + r * std::cos(gamma)};
  }
};

/// Each degree, and the measured angles.
std::vector<double> gammas_of(const LuminousIntensityDistribution& distribution) {
  const std::vector<double>& measured = distribution.vertical_deg();
  std::vector<double> gammas(measured.begin(), measured.end());
  for (int degree = 0; degree <= 180; ++degree)
    if (degree > measured.front() && degree < measured.back()) gammas.push_back(degree);
  std::sort(gammas.begin(), gammas.end());
  gammas.erase(std::unique(gammas.begin(), gammas.end()), gammas.end());
  return gammas;
}

std::vector<Curve> curves_of(const LuminousIntensityDistribution& distribution) {
  std::vector<Curve> curves{{0, 1, {}}, {180, -1, {}}, {90, 1, {}}, {270, -1, {}}};
  for (Curve& curve : curves)
    for (const double gamma : gammas_of(distribution))
      curve.points.push_back({gamma, distribution(curve.c_deg, gamma)});
  return curves;
}

/// The most of the curves, where gamma is above `from_deg`.
double most_candela(const std::vector<Curve>& curves, double from_deg) {
  double most = 0;
  for (const Curve& curve : curves)
    for (const auto& [gamma, candela] : curve.points)
      if (gamma > from_deg) most = std::max(most, candela);
  return most;
}

std::string curve_as_svg(const Curve& curve, const Polar& polar, const std::string& attributes) {
  std::string text = "<polyline fill=\"none\" stroke-width=\"2\" " + attributes + " points=\"";
  for (const auto& [gamma, candela] : curve.points) {
    const auto [x, y] = polar.at(gamma, candela, curve.side);
    text += svg_number(x) + "," + svg_number(y) + " ";
  }
  return text + "\"/>\n";
}

/// A circle, or its lower half.
std::string ring_as_svg(const Polar& polar, double candela, bool whole) {
  const double r = kRadius * candela / polar.full_candela;
  const std::string radius = svg_number(r), y = svg_number(polar.center_y);
  if (whole)
    return "<circle cx=\"" + svg_number(kMiddle) + "\" cy=\"" + y + "\" r=\"" + radius +
           "\" fill=\"none\" stroke=\"#d4d4d4\"/>\n";
  return "<path d=\"M" + svg_number(kMiddle - r) + "," + y + " A" + radius + "," + radius +
         " 0 0 0 " + svg_number(kMiddle + r) + "," + y + "\" fill=\"none\" stroke=\"#d4d4d4\"/>\n";
}

std::string grid_as_svg(const Polar& polar, double step, bool whole) {
  std::string text, labels;
  for (double candela = step; candela <= polar.full_candela * (1 + 1e-9); candela += step)
    text += ring_as_svg(polar, candela, whole);
  for (int gamma = 0; gamma <= (whole ? 180 : 90); gamma += 30)
    for (const double side : {-1.0, 1.0}) {
      const auto [x, y] = polar.at(gamma, polar.full_candela, side);
      const auto [label_x, label_y] = polar.at(gamma, 1.07 * polar.full_candela, side);
      text += svg_line(kMiddle, polar.center_y, x, y, "stroke=\"#d4d4d4\"");
      if (side > 0 || gamma % 180 != 0)
        labels +=
            svg_text(label_x, label_y + 5, "text-anchor=\"middle\"", std::to_string(gamma) + "°");
    }
  return text + labels;
}

std::string ring_labels_as_svg(const Polar& polar, double step) {
  std::string text;
  for (double candela = step; candela <= polar.full_candela * (1 + 1e-9); candela += step) {
    const auto [x, y] = polar.at(0, candela, 1);
    text += svg_label(x + 4, y - 4, "font-size=\"11\"", "#606060", number(candela, 9));
  }
  return text;
}

std::string legend_as_svg(double y) {
  const auto entry = [y](double x, const std::string& stroke, const std::string& label) {
    return svg_line(x, y, x + 34, y, stroke + " stroke-width=\"2\"") +
           svg_text(x + 42, y + 4, "font-size=\"12\"", label);
  };
  return entry(120, "stroke=\"#c2410c\"", "C 180° (left) and C 0° (right)") +
         entry(350, "stroke=\"#1d4ed8\" stroke-dasharray=\"7 4\"", "C 270° and C 90°");
}

}  // namespace

std::string polar_plot_svg(const LuminousIntensityDistribution& distribution,
                           const std::string& title) {
  const std::vector<Curve> curves = curves_of(distribution);
  const double most = most_candela(curves, -1);
  const double step = most > 0 ? round_step(most, 6) : 1;
  const bool whole = most_candela(curves, 90) > 0.005 * most;
  const Polar polar{whole ? kTop + kRadius : kTop,
                    most > 0 ? std::ceil(most / step - 1e-9) * step : 1};
  const double bottom = polar.center_y + kRadius;
  std::string svg =
      svg_start(kWidth, bottom + 70, title) +
      svg_text(kMiddle, 30, "text-anchor=\"middle\" font-size=\"16\"",
               escaped(shortened(title, 75))) +
      svg_text(kMiddle, 52, "text-anchor=\"middle\" font-size=\"12\" fill=\"#606060\"",
               "luminous intensity, candela, over gamma (0° is down)") +
      grid_as_svg(polar, step, whole) + ring_labels_as_svg(polar, step);
  for (const Curve& curve : curves)
    svg += curve_as_svg(curve, polar,
                        curve.c_deg == 90 || curve.c_deg == 270
                            ? "stroke=\"#1d4ed8\" stroke-dasharray=\"7 4\""
                            : "stroke=\"#c2410c\"");
  return svg + legend_as_svg(bottom + 48) + "</svg>\n";
}

}  // namespace glare::tool
