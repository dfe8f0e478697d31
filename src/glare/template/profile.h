// What a template shows, in numbers: its radial profile and how its light is spread.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "glare/color/color_space.h"
#include "glare/scatter/straylight.h"
#include "glare/template/glare_template.h"

namespace glare {

/// Mean luminance over a ring around the axis.
struct ProfileRing {
  double inner_deg = 0;
  double outer_deg = 0;
  double mean_per_steradian = 0;
};

/// Luminance over angle: rings from the axis to the nearest border, each a factor 10^0.1 wider than
/// the one within it, and none but the innermost, the axis' own pixel, narrower than a pixel.
/// Angles are direction sines in degrees; a pixel belongs to the ring that its centre is in.
std::vector<ProfileRing> radial_profile(const GlareTemplate& glare_template);

/// The CIE general equation (`cie_general_glare`), per steradian, averaged as the template is in
/// each of `rings`, its radial profile: over the squares of the same pixels. Nothing for rings that
/// begin below the equation's 0.1 degrees or end beyond 90. Throws `OptionError` for an eye out of
/// range.
std::vector<std::optional<double>> cie_profile(const GlareTemplate& glare_template,
                                               const std::vector<ProfileRing>& rings,
                                               const Straylight& eye);

/// Share of all the light that falls within `radius_deg` of the axis, 0 to 1; pixels on the circle
/// count by the share of their area inside. Nothing where the circle isn't wholly inside the
/// template's pixels, or its radius is less than a pixel: how the light lies within one isn't
/// known.
std::optional<double> encircled_energy(const GlareTemplate& glare_template, double radius_deg);

/// A pixel and its luminance, in the template's own normalisation.
struct Peak {
  int x = 0;  ///< Column, from 0 on the left.
  int y = 0;  ///< Row, from 0 at the top.
  double luminance = 0;
};

/// The brightest pixel, the first of several; the template has at least one.
Peak peak(const GlareTemplate& glare_template);

/// Chromaticity of all the light in the template together: of the sum of its pixels' XYZ.
Chromaticity mean_chromaticity(const GlareTemplate& glare_template);

}  // namespace glare
