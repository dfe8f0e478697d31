#include "glare/integration/point_interpolation.h"

#include <algorithm>

namespace glare {

PointInterpolation::PointInterpolation(const WindowedSinc& kernel) : taps_(kernel.taps) {
  for (int i = 0; i <= kSteps; ++i)
    weights_.push_back(interpolation_weights(kernel, static_cast<double>(i) / kSteps));
}

WindowedSinc::PerTap PointInterpolation::weights_at(double fraction) const {
  const double steps = fraction * kSteps;
  const int step = std::min(static_cast<int>(steps), kSteps - 1);
  const double rest = steps - step;
  WindowedSinc::PerTap weights;
  for (int j = 0; j < WindowedSinc::kMostTaps; ++j)
    weights[j] = weights_[step][j] + rest * (weights_[step + 1][j] - weights_[step][j]);
  return weights;
}

}  // namespace glare
