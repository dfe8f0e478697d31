#include "glare/color/tone_map.h"

#include <algorithm>
#include <cmath>

#include "glare/color/color_space.h"
#include "glare/color/gamut.h"

namespace glare {

namespace {

float srgb_encoded(double linear) {
  const double v = std::clamp(linear, 0.0, 1.0);
  return static_cast<float>(v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
}

/// A colour of luminance 1 brought to `luminance`; where a channel would leave the display's range,
/// the colour moves towards grey until it stays inside.
std::array<float, 3> displayed(const std::array<float, 3>& unit_rgb, double luminance) {
  const double largest = std::max({unit_rgb[0], unit_rgb[1], unit_rgb[2]});
  double keep = 1;
  if (luminance * largest > 1) keep = (1 - luminance) / (luminance * (largest - 1));
  std::array<float, 3> result;
  for (int k = 0; k < 3; ++k) result[k] = srgb_encoded(luminance * (1 + keep * (unit_rgb[k] - 1)));
  return result;
}

}  // namespace

std::array<float, 3> SigmoidToneMap::operator()(const std::array<float, 3>& rgb) const {
  static const Vector3 weights = lin_rec709_color_space().xyz_from_rgb()[1];
  const double luminance = weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2];
  if (!(luminance > 0)) return {0, 0, 0};
  const auto unit = desaturated_into_gamut(
      {static_cast<float>(rgb[0] / luminance), static_cast<float>(rgb[1] / luminance),
       static_cast<float>(rgb[2] / luminance)},
      weights);
  const double c = std::pow(luminance / middle_luminance, 1 / compression);
  return displayed(unit, c / (c + 1));
}

}  // namespace glare
