// Fourier transforms of a few samples and many zeros. Internal.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "glare/base/aligned_buffer.h"
#include "glare/diffraction/fourier_transform.h"

namespace glare {

/// Transforms of `length` values of which only the first `samples` aren't zero, X[k] = sum over n
/// of x[n] exp(-2 pi i k n / length). Done as four transforms of a quarter of the length, one for
/// each remainder r of k / 4:
///   X[4 q + r] = sum over n < length / 4 of y_r[n] exp(-2 pi i q n / (length / 4)),
///   y_r[n] = exp(-2 pi i r n / length) * sum over j of (-i)^(r j) x[n + j length / 4].
/// With padding 4 the inner sum has one term, and what is left out is the transform's work on
/// zeros; a quarter also stays in the processor's nearest cache. (Decimation in frequency; Markel,
/// "FFT pruning", 1971.)
class PaddedTransform {
 public:
  static constexpr int kParts = 4;

  /// `length` is a multiple of 4 and at least `samples`.
  PaddedTransform(int samples, int length);

  /// `samples` rounded up to whole quarters of the length.
  int input_count() const { return quarters_ * quarter_; }

  /// X, by remainder: frequencies[r][q] is X[4 q + r].
  using Frequencies = std::array<const std::complex<float>*, kParts>;

  /// Memory that one thread's transforms are computed in.
  struct Workspace {
    GrowingBuffer<std::complex<float>> inputs;
    GrowingBuffer<std::complex<float>> frequencies;
  };

  /// `input` holds `input_count` values, zeros after the samples. The result is in `workspace`.
  Frequencies execute(std::span<const std::complex<float>> input, Workspace& workspace) const;

  /// The length of the transforms that one of `length` is done with.
  static int part_length(int length) { return length / kParts; }
  /// Bytes that it takes, with one workspace.
  static std::uint64_t bytes(int length);

 private:
  int quarter_;
  int quarters_;
  FourierTransform transform_;
  std::vector<std::complex<float>> turns_;  ///< exp(-2 pi i r n / length), r = 1, 2, 3.
};

}  // namespace glare
