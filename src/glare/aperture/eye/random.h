// The built-in eye's chance. Internal.
#pragma once

#include <cmath>
#include <cstdint>

#include "glare/aperture/eye/split_mix.h"

namespace glare {

/// `value` smoothly kept within +-`most`; up to two thirds of that it changes by 1.4 % at most.
inline double limited(double value, double most) {
  return value / std::pow(1 + std::pow(value / most, 6), 1.0 / 6);
}

/// The parts of an eye that have random numbers of their own.
enum class EyePart : std::uint64_t {
  pupil = 1,
  hippus,
  blinks,
  upper_lashes,
  lower_lashes,
  particles,
  lens
};

inline std::uint64_t seed_for(std::uint64_t seed, EyePart part, std::uint64_t index = 0) {
  return SplitMix(seed).next() ^ ((static_cast<std::uint64_t>(part) << 32) + index);
}
inline SplitMix random_for(std::uint64_t seed, EyePart part, std::uint64_t index = 0) {
  return SplitMix(SplitMix(seed_for(seed, part, index)).next());
}

}  // namespace glare
