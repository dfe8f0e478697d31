// Large templates at the pitch of the transform's own bins, for accuracy and for time.
#pragma once

#include "glare/aperture/aperture.h"
#include "glare/diffraction/far_field.h"
#include "glare/integration/spectral_integral.h"
#include "glare/spectrum/observer.h"
#include "support/exact_pixels.h"

namespace glare::test {

/// An aperture zero-padded four times to the transform's length, and pixels as far apart as the
/// transform's bins are at 560 nm. The pattern's finest detail is four pixels wide, so that nothing
/// of it is averaged away, and it goes round as many cycles from 380 to 780 nm as it ever does.
struct BinsPitchCase {
  Aperture aperture;  ///< A pupil with eyelashes, as wide as its picture of 8 mm.
  PixelGrid grid;
  WavelengthRange range{380, 780};

  /// `output` pixels a side; the aperture has a quarter of `transform_length` samples a side.
  BinsPitchCase(int output, int transform_length);

  /// The far field that the library asks for.
  FarField field(int threads) const;

  /// For the reference: the pixels of this template and the whole range.
  exact::PixelRequest request(std::vector<exact::Pixel> pixels) const;
};

}  // namespace glare::test
