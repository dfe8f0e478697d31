// The pixels around the axis, by a sum over wavenumbers. Internal.
#pragma once

#include "glare/base/progress.h"
#include "glare/diffraction/far_field.h"
#include "glare/integration/spectral_integral.h"
#include "glare/spectrum/observer.h"
#include "glare/spectrum/spectrum.h"

namespace glare {

/// Integrates the pixels with |dx|, |dy| < `end_px`, counted from the axis, and writes them.
void integrate_inner_pixels(const FarField& field, const PixelGrid& grid, int end_px,
                            const Spectrum& lamp, const ColorMatchingFunctions& observer,
                            const WavelengthRange& range, int threads,
                            const ProgressCallback& progress, XyzImage& image);

}  // namespace glare
