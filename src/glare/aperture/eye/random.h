// The built-in eye's chance: the same on every machine. Internal.
#pragma once

#include <cmath>
#include <cstdint>

namespace glare {

/// SplitMix64 (Steele, Lea, Flood 2014), because the standard library's distributions differ from
/// one implementation to the next.
class Random {
 public:
  /// `part` tells apart the streams of one eye.
  explicit Random(std::uint64_t seed, std::uint64_t part = 0) : state_(seed) {
    state_ = next() ^ part;
    state_ = next();
  }

  double between(double low, double high) {
    constexpr double per_step = 0x1p-53;
    return low + (high - low) * (static_cast<double>(next() >> 11) * per_step);
  }

  /// Of mean 0 and variance 1, within +-3: three uniform numbers' sum.
  double around_zero() { return between(-1, 1) + between(-1, 1) + between(-1, 1); }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

/// `value` smoothly kept within +-`most`; up to two thirds of that it changes by 1.4 % at most.
inline double limited(double value, double most) {
  return value / std::pow(1 + std::pow(value / most, 6), 1.0 / 6);
}

/// The parts of an eye that have a stream of their own.
enum class EyePart : std::uint64_t { pupil = 1, hippus, blinks, upper_lashes, lower_lashes };

inline Random random_for(std::uint64_t seed, EyePart part, std::uint64_t index = 0) {
  return Random(seed, (static_cast<std::uint64_t>(part) << 32) + index);
}

}  // namespace glare
