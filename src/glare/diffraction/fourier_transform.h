// One-dimensional Fourier transforms in single precision. Internal.
//
// This is the only file (with its .cpp) that knows the transform's library, FFTW; another with the
// same interface can take its place.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace glare {

/// Memory aligned as the transforms want it.
template <typename T>
class TransformBuffer {
 public:
  explicit TransformBuffer(std::size_t count);
  std::span<T> values() { return {data_.get(), count_}; }

 private:
  struct Release {
    void operator()(T* data) const;
  };
  std::unique_ptr<T[], Release> data_;
  std::size_t count_;
};

/// A plan for transforms of one length, X[k] = sum over n of x[n] exp(-2 pi i k n / length), not
/// normalised. Planned without timing, so that a plan, and so every bit of a result, depends on the
/// length and the machine alone. Execution may go on in several threads at once, each with buffers
/// of its own.
class FourierTransform {
 public:
  enum class Kind { real_to_complex, complex_to_complex };

  FourierTransform(Kind kind, int length);
  ~FourierTransform();
  FourierTransform(const FourierTransform&) = delete;
  FourierTransform& operator=(const FourierTransform&) = delete;

  /// `input` holds `length` values, `output` length / 2 + 1; the input is destroyed.
  void execute(TransformBuffer<float>& input, TransformBuffer<std::complex<float>>& output) const;

  /// In place, `length` values.
  void execute(TransformBuffer<std::complex<float>>& values) const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

/// The smallest even length of at least `minimum` that has no prime factor above 7, for which
/// transforms are fast.
int fast_transform_length(int minimum);

}  // namespace glare
