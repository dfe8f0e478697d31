// The transforms that the spectral stage and the convolution are compared with.
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

/// FFTW's own two-dimensional transforms of columns x rows floats to complex numbers and back, on
/// so many threads, planned by estimate, as the library's are by default.
class FftwThereAndBack {
 public:
  FftwThereAndBack(int columns, int rows, int threads);
  ~FftwThereAndBack();

  void run();

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace glare::bench
