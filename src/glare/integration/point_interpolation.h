// Point values between the samples of a band-limited function, by table. Internal.
#pragma once

#include <vector>

#include "glare/integration/windowed_sinc.h"

namespace glare {

/// The weights of a kernel for every fraction of a sample, linear between table entries.
class PointInterpolation {
 public:
  explicit PointInterpolation(const WindowedSinc& kernel);

  int taps() const { return taps_; }
  /// Weights of the samples from floor(place) - taps / 2 + 1 on.
  WindowedSinc::PerTap weights_at(double fraction) const;

 private:
  static constexpr int kSteps = 1024;
  int taps_;
  std::vector<WindowedSinc::PerTap> weights_;
};

}  // namespace glare
