// Fourier transforms of rays side by side. Internal.
//
// FFTW makes the far field. Here its transforms of interleaved signals would take a third of all
// the time: they use half of the vectors' width at most. When each vector holds the same sample of
// many signals, a transform is additions and multiplications of whole vectors, with nothing to
// shuffle (docs/performance.md has both times).
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "glare/diffraction/fourier_transform.h"
#include "glare/integration/vector_transform.h"

namespace glare {

/// Transforms of a block of kRaysPerBlock / 2 complex signals, one row for each sample, not
/// normalised: X[k] = sum over n of x[n] exp(-+ 2 pi i k n / length). After Stockham: each pass
/// splits off a factor of the length and writes the samples in their final order.
class BlockTransform {
 public:
  static constexpr int kSignals = kRaysPerBlock / 2;
  using Buffer = GrowingBuffer<std::complex<float>>;

  /// `length` is a product of 2, 3 and 5, at least 2.
  explicit BlockTransform(int length);
  /// The smallest even one of such lengths that is at least `minimum`.
  static int length_for(int minimum);

  int length() const { return length_; }

  /// Row r of the input begins at `input + r * stride`, is aligned to 64 bytes and is kept. The
  /// result is in one of the buffers.
  std::span<std::complex<float>> forward(const std::complex<float>* input, std::size_t stride,
                                         Buffer& a, Buffer& b) const;
  std::span<std::complex<float>> backward(const std::complex<float>* input, std::size_t stride,
                                          Buffer& a, Buffer& b) const;

 private:
  std::span<std::complex<float>> run(bool backward, const std::complex<float>* input,
                                     std::size_t stride, Buffer& a, Buffer& b) const;
  struct Pass {
    TransformPass forward, backward;
    /// exp(-+ 2 pi i p j / n) for each p, j = 1 ... radix - 1.
    std::vector<std::complex<float>> turns, turns_back;
  };
  int length_;
  std::vector<Pass> passes_;
};

}  // namespace glare
