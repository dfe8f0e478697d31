#include "support/pixel_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "glare/color/color_space.h"
#include "support/color_difference.h"

namespace glare::test {

double percentile(std::vector<double> values, double share) {
  const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + k, values.end());
  return values[static_cast<std::size_t>(k)];
}

PixelErrors::PixelErrors(const XyzImage& found, const std::vector<exact::Pixel>& pixels,
                         const std::vector<Xyz>& expected) {
  const Xyz white = xyz_from_chromaticity({0.3127, 0.3290});
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Xyz xyz;
    for (std::size_t k = 0; k < 3; ++k) xyz[k] = found[k](pixels[i].x, pixels[i].y);
    luminance.push_back(std::abs(xyz[1] / expected[i][1] - 1));
    delta_e.push_back(ciede2000_at_own_luminance(xyz, expected[i], white));
  }
}

}  // namespace glare::test
