// Random numbers that are the same on every machine. Internal.
#pragma once

#include <cstdint>

namespace glare {

/// SplitMix64 (Steele, Lea, Flood 2014), because the standard library's distributions differ from
/// one implementation to the next.
class SplitMix {
 public:
  explicit SplitMix(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  double between(double low, double high) {
    constexpr double per_step = 0x1p-53;
    return low + (high - low) * (static_cast<double>(next() >> 11) * per_step);
  }

  /// Mean 0, standard deviation 1: the sum of 12 uniform deviates.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += between(0, 1);
    return sum;
  }

 private:
  std::uint64_t state_;
};

}  // namespace glare
