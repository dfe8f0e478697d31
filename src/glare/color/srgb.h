// The transfer curve of sRGB displays (IEC 61966-2-1). Internal.
#pragma once

#include <cmath>

namespace glare {

/// What is sent to the display to show `linear` of its white; both in [0, 1].
inline double srgb_encoded(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// And back.
inline double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace glare
