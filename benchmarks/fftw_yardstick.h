// The transform that the spectral stage is compared with.
#pragma once

#include <memory>

namespace glare::bench {

/// FFTW's own two-dimensional transform of n x n floats to n x (n / 2 + 1) complex numbers, one
/// thread, planned with FFTW_MEASURE. Planning takes seconds.
class FftwYardstick {
 public:
  explicit FftwYardstick(int n);
  ~FftwYardstick();

  void run();

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace glare::bench
