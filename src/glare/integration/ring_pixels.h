// The pixels but for the innermost, by convolution along rays. Internal.
#pragma once

#include "glare/base/progress.h"
#include "glare/diffraction/far_field.h"
#include "glare/integration/ray_band.h"
#include "glare/integration/spectral_integral.h"
#include "glare/spectrum/observer.h"
#include "glare/spectrum/spectrum.h"

namespace glare {

/// Integrates the pixels with |dx| or |dy| of at least `begin_px`, counted from the axis, and
/// writes them.
void integrate_ring_pixels(const FarField& field, const PixelGrid& grid, const SubPixels& sub,
                           int begin_px, const Spectrum& lamp,
                           const ColorMatchingFunctions& observer, const WavelengthRange& range,
                           int threads, const ProgressCallback& progress, XyzImage& image);

}  // namespace glare
