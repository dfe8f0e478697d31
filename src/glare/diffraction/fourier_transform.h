// One-dimensional Fourier transforms in single precision. Internal.
//
// This is the only file (with its .cpp) that knows the transform's library, FFTW; another with the
// same interface can take its place.
#pragma once

#include <complex>
#include <memory>
#include <span>

#include "glare/base/aligned_buffer.h"

namespace glare {

/// A plan for transforms of one length, X[k] = sum over n of x[n] exp(-2 pi i k n / length), not
/// normalised. Planned without timing, unless `measure_transforms` has been called, so that a plan,
/// and so every bit of a result, depends on the length and the machine alone. Execution may go on
/// in several threads at once.
class FourierTransform {
 public:
  enum class Kind { real_to_complex, complex_to_complex };

  /// Each start of an input or output lies at a multiple of so many bytes.
  static constexpr int kAlignment = 64;

  FourierTransform(Kind kind, int length);
  ~FourierTransform();
  FourierTransform(const FourierTransform&) = delete;
  FourierTransform& operator=(const FourierTransform&) = delete;

  /// `input` holds `length` values, `output` length / 2 + 1; the input is destroyed.
  void execute(AlignedBuffer<float>& input, AlignedBuffer<std::complex<float>>& output) const;

  /// Both hold `length` values and don't overlap; the input is destroyed.
  void execute(std::span<std::complex<float>> input, std::span<std::complex<float>> output) const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

/// The smallest even length of at least `minimum` that has no prime factor above 7, for which
/// transforms are fast.
int fast_transform_length(int minimum);

}  // namespace glare
