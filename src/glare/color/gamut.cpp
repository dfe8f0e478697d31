#include "glare/color/gamut.h"

#include <algorithm>

namespace glare {

std::array<float, 3> desaturated_into_gamut(const std::array<float, 3>& rgb,
                                            const std::array<double, 3>& luminance_weights) {
  const double smallest = std::min({rgb[0], rgb[1], rgb[2]});
  if (smallest >= 0) return rgb;
  const double luminance =
      luminance_weights[0] * rgb[0] + luminance_weights[1] * rgb[1] + luminance_weights[2] * rgb[2];
  if (luminance <= 0) return {0, 0, 0};
  const double keep = luminance / (luminance - smallest);
  std::array<float, 3> result;
  for (int k = 0; k < 3; ++k)
    result[k] = static_cast<float>(std::max(0.0, luminance + keep * (rgb[k] - luminance)));
  return result;
}

std::array<float, 3> limited_to_white(const std::array<float, 3>& unit_rgb, double luminance) {
  const double largest = std::max({unit_rgb[0], unit_rgb[1], unit_rgb[2]});
  double keep = 1;
  if (luminance * largest > 1) keep = (1 - luminance) / (luminance * (largest - 1));
  std::array<float, 3> result;
  for (int k = 0; k < 3; ++k)
    result[k] =
        static_cast<float>(std::clamp(luminance * (1 + keep * (unit_rgb[k] - 1)), 0.0, 1.0));
  return result;
}

}  // namespace glare
