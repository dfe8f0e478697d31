// A template's radial profile and the CIE glare curve as a drawing.
#pragma once

#include <string>
#include <vector>

#include "glare/scatter/straylight.h"
#include "glare/template/profile.h"

namespace glare::tool {

struct ProfilePlot {
  std::string title;
  std::string curve_label;         ///< In the legend, of the CIE curve.
  std::vector<ProfileRing> rings;  ///< Those that are dark, or beyond 90 degrees, aren't drawn.
  Straylight eye;                  ///< Whose CIE curve is drawn.
};

/// The plot as SVG 1.1: angle in degrees against luminance per steradian, both logarithmic.
std::string profile_plot_svg(const ProfilePlot& plot);

}  // namespace glare::tool
