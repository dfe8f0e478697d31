// The far field of an aperture that also shifts the light's phase. Internal.
#pragma once

#include <complex>
#include <cstdint>
#include <functional>
#include <span>

#include "glare/diffraction/far_field.h"

namespace glare {

/// An aperture's open part: row y (0 to height - 1) of its complex amplitudes, `width` of them.
struct ComplexOpenPart {
  int width = 0;
  int height = 0;
  double pixel_mm = 0;
  double energy_area_mm2 = 0;  ///< The integral of |t|^2.
  std::function<void(int y, std::span<std::complex<float>>)> row;
};

/// I(f) of a complex aperture has no symmetry: it is the sum of an even part, I(-f) = I(f), and an
/// odd one, I(-f) = -I(f) (`FarField::odd`), each held by its half plane.
struct FarFieldParts {
  FarField even;
  FarField odd;
};

/// As `far_field`, of a complex aperture. `aperture_width_mm` is not set.
FarFieldParts complex_far_field(const ComplexOpenPart& part, const FarFieldRequest& request);

/// Bytes that it takes at its peak, with the result.
std::uint64_t complex_far_field_bytes(int width, int height, double pixel_mm,
                                      const FarFieldRequest& request);

}  // namespace glare
