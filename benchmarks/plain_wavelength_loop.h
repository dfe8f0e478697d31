// The spectral integral as a plain program has it: one rescaled picture a wavelength. Only a
// yardstick for time.
#pragma once

#include "glare/diffraction/far_field.h"
#include "glare/integration/spectral_integral.h"

namespace glare::bench {

/// The far field's intensity over the whole plane: column x, row y is the sample at the frequency
/// ((x - center_x) bin_x, (y - center_y) bin_y).
struct PlainFarField {
  Image<float> intensity_mm2;
  int center_x = 0;
  int center_y = 0;
  double bin_x_per_mm = 0;
  double bin_y_per_mm = 0;
};

PlainFarField plain_far_field(const FarField& field);

/// XYZ per steradian in the middle of each pixel: for each of `wavelengths` evenly spaced
/// wavelengths the intensity, bilinear between its samples, is scaled to the pixels and added up.
/// One thread.
XyzImage plain_wavelength_loop(const PlainFarField& field, const PixelGrid& grid,
                               const Spectrum& lamp, const ColorMatchingFunctions& observer,
                               const WavelengthRange& range, int wavelengths);

}  // namespace glare::bench
