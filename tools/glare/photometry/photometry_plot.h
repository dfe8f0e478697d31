// Luminous intensity over direction as drawings, as luminaires' data sheets have them.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "glare/photometry/luminous_intensity.h"

namespace glare::tool {

/// For a luminaire of type C: intensity over gamma as the distance from the middle, gamma 0 down,
/// in the half-planes C 0 (right) and C 180 (left), and C 90 and C 270. SVG 1.1.
std::string polar_plot_svg(const LuminousIntensityDistribution& distribution,
                           const std::string& title);

/// The degrees that are drawn, ascending; by default those around the bright part of the beam.
struct PlotRange {
  std::optional<std::array<double, 2>> h_deg, v_deg;
};

/// For type A and B: lines of equal intensity over H and V, at 1, 2 and 5 times powers of ten, from
/// the peak's to a thousandth of it; by default around the directions that have a fiftieth of it.
/// SVG 1.1. Throws `OptionError` for a range that doesn't ascend or isn't within what was measured.
std::string isocandela_plot_svg(const LuminousIntensityDistribution& distribution,
                                const std::string& title, const PlotRange& range = {});

/// The one of these that suits the distribution's type. Throws `OptionError` for a range and type
/// C.
std::string photometry_plot_svg(const LuminousIntensityDistribution& distribution,
                                const std::string& title, const PlotRange& range = {});

}  // namespace glare::tool
