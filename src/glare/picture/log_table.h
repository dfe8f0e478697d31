// A function of positive floats from a table. Internal.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace glare {

/// A smooth function's values at 2^`step_bits` equal steps in each octave, with straight lines
/// between. Of x^a the relative error is below |a (a - 1)| / (8 * 4^step_bits).
class LogTable {
 public:
  /// For arguments from 2^`first_octave` to 2^`end_octave`, both in -126 to 127.
  template <typename Function>
  LogTable(int first_octave, int end_octave, int step_bits, const Function& function)
      : least_(std::ldexp(1.0f, first_octave)),
        largest_(std::nextafter(std::ldexp(1.0f, end_octave), 0.0f)),
        shift_(23 - step_bits) {
    const auto count = static_cast<std::uint32_t>(end_octave - first_octave) << step_bits;
    pieces_.resize(count);
    double value = function(static_cast<double>(least_));
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t next_bits = std::bit_cast<std::uint32_t>(least_) + ((i + 1) << shift_);
      const double next = function(static_cast<double>(std::bit_cast<float>(next_bits)));
      const double step = std::ldexp(next - value, -shift_);
      pieces_[i] = {static_cast<float>(value), static_cast<float>(step)};
      value = next;
    }
  }

  /// The function's value at `x`, or at the end that is nearer; of NaN, at the first.
  float operator()(float x) const {
    const float inside = std::min(std::max(least_, x), largest_);
    const std::uint32_t bits =
        std::bit_cast<std::uint32_t>(inside) - std::bit_cast<std::uint32_t>(least_);
    const Piece piece = pieces_[bits >> shift_];
    const auto rest = static_cast<std::int32_t>(bits & ((1u << shift_) - 1));
    return piece.value + piece.step * static_cast<float>(rest);
  }

 private:
  struct Piece {
    float value, step;  ///< At its start, and from one float to the next.
  };

  float least_, largest_;
  int shift_;
  std::vector<Piece> pieces_;
};

}  // namespace glare
