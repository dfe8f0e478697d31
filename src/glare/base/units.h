// Factors between units.
#pragma once

#include <numbers>

namespace glare {

inline constexpr double kMmPerNm = 1e-6;
inline constexpr double kRadPerDeg = std::numbers::pi / 180;

}  // namespace glare
