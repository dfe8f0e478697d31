// How densely a far field samples its pattern. Internal.
#pragma once

#include <algorithm>

#include "glare/diffraction/far_field.h"

namespace glare {

/// Zero-padding by which samples are at twice the critical rate: the intensity has twice the
/// aperture's bandwidth. Short kernels interpolate such samples; sparser ones need longer kernels.
inline constexpr double kDensePadding = 4;

inline bool is_densely_sampled(const FarField& field) {
  constexpr double kRounding = 1e-9;
  const double padding =
      1 / std::max(field.bin_x_per_mm * field.extent_x_mm, field.bin_y_per_mm * field.extent_y_mm);
  return padding >= kDensePadding - kRounding;
}

}  // namespace glare
