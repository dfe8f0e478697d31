#include "support/beams.h"

#include <cstddef>

namespace glare::test {

std::vector<double> steps(double first, double last, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(first + (last - first) * i / (count - 1));
  return angles;
}

LuminousIntensityDistribution sampled(PhotometricType type, const std::vector<double>& horizontal,
                                      const std::vector<double>& vertical,
                                      const std::function<double(const Vector3&)>& beam,
                                      bool gamma_zero_is_forward) {
  Image<float> candela(static_cast<int>(horizontal.size()), static_cast<int>(vertical.size()));
  for (int j = 0; j < candela.height(); ++j)
    for (int i = 0; i < candela.width(); ++i)
      candela(i, j) = static_cast<float>(beam(
          direction_from_angles(type, horizontal[static_cast<std::size_t>(i)],
                                vertical[static_cast<std::size_t>(j)], gamma_zero_is_forward)));
  return {type, horizontal, vertical, candela};
}

}  // namespace glare::test
