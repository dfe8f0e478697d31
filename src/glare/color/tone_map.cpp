#include "glare/color/tone_map.h"

#include <cmath>

#include "glare/color/color_space.h"
#include "glare/color/gamut.h"
#include "glare/color/srgb.h"

namespace glare {

std::array<float, 3> SigmoidToneMap::operator()(const std::array<float, 3>& rgb) const {
  static const Vector3 weights = lin_rec709_color_space().xyz_from_rgb()[1];
  const double luminance = weights[0] * rgb[0] + weights[1] * rgb[1] + weights[2] * rgb[2];
  if (!(luminance > 0)) return {0, 0, 0};
  const auto unit = desaturated_into_gamut(
      {static_cast<float>(rgb[0] / luminance), static_cast<float>(rgb[1] / luminance),
       static_cast<float>(rgb[2] / luminance)},
      weights);
  const double c = std::pow(luminance / middle_luminance, 1 / compression);
  std::array<float, 3> shown = limited_to_white(unit, c / (c + 1));
  for (float& value : shown) value = static_cast<float>(srgb_encoded(value));
  return shown;
}

}  // namespace glare
