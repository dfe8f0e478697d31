#include "glare/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace glare {

double median_luminance(const std::array<Image<float>, 3>& channels,
                        const RgbColorSpace& color_space) {
  const Vector3& weights = color_space.xyz_from_rgb()[1];
  const auto red = channels[0].values(), green = channels[1].values(), blue = channels[2].values();
  std::vector<double> luminances;
  luminances.reserve(red.size());
  for (std::size_t i = 0; i < red.size(); ++i) {
    const double luminance = weights[0] * red[i] + weights[1] * green[i] + weights[2] * blue[i];
    if (luminance > 0 && std::isfinite(luminance)) luminances.push_back(luminance);
  }
  if (luminances.empty()) return 1;
  const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  return *middle;
}

}  // namespace glare
