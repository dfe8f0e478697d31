// The integral over wavelength: from the far field of an aperture to XYZ in every pixel.
#pragma once

#include <array>
#include <cstdint>

#include "glare/base/image.h"
#include "glare/base/progress.h"
#include "glare/diffraction/far_field.h"
#include "glare/spectrum/observer.h"
#include "glare/spectrum/spectrum.h"

namespace glare {

/// The directions of a template's pixels. Pixel (i, j) is the square of side `pitch_rad` centred on
/// the direction sines ((i - width / 2) pitch_rad, (j - height / 2) pitch_rad), integer division.
struct PixelGrid {
  int width = 0;
  int height = 0;
  double pitch_rad = 0;

  int center_x() const { return width / 2; }
  int center_y() const { return height / 2; }
};

/// X, Y, Z of every pixel, as three pictures.
using XyzImage = std::array<Image<float>, 3>;

/// The mean over each pixel's square, per steradian, of
///   XYZ(theta) = integral of PSF(theta, lambda) S (x̄, ȳ, z̄) dlambda / integral of S ȳ dlambda
/// over `range`, where PSF(theta, lambda) = I(theta / lambda) / lambda^2 and I is the far field.
/// The number of wavelengths follows from how fast the pattern changes with wavelength at each
/// place, so that it leaves no trace. The result is point-symmetric about the axis, and its bytes
/// are the same for any number of threads (0: as many as the machine has).
///
/// The far field must hold every frequency that the outermost pixels need (see
/// `far_field_request`), else `OptionError`. Throws `InputError` where the lamp has no light that
/// the observer sees, `Cancelled` when the callback says stop.
XyzImage spectral_integral(const FarField& field, const PixelGrid& grid, const Spectrum& lamp,
                           const ColorMatchingFunctions& observer, const WavelengthRange& range,
                           int threads, const ProgressCallback& progress);

/// The same into pictures of before, whose memory is used again where their size is right.
void spectral_integral(const FarField& field, const PixelGrid& grid, const Spectrum& lamp,
                       const ColorMatchingFunctions& observer, const WavelengthRange& range,
                       int threads, const ProgressCallback& progress, XyzImage& result);

/// The far field that `spectral_integral` needs for these pixels and wavelengths: as far out as the
/// outer edges of the outermost pixels at the shortest wavelength, and sampled as finely as their
/// size asks for. `open_side_mm` is the shorter side of the rectangle that holds all of the
/// aperture's open part.
FarFieldRequest far_field_request(double open_side_mm, const PixelGrid& grid,
                                  const WavelengthRange& range);

/// Bytes that `spectral_integral` takes at its peak, besides the field and the result, for an open
/// part whose longer side is `open_side_mm`. An upper bound.
std::uint64_t spectral_integral_bytes(double open_side_mm, const PixelGrid& grid,
                                      const WavelengthRange& range, int threads);

}  // namespace glare
