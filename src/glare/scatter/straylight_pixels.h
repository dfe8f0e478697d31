// Straylight in the pixels of a template. Internal.
#pragma once

#include "glare/base/progress.h"
#include "glare/integration/spectral_integral.h"
#include "glare/scatter/straylight.h"

namespace glare {

/// Each of `pixels` (per steradian, the light's integral `lamp_xyz`) becomes
///   (1 - s) pixel + lamp_xyz mean of S,
/// the mean being over the pixel's square, to 1e-5, and s the `scattered_energy`: what is taken
/// from the diffracted light is put, in the lamp's colour, where it is scattered to, and all of it
/// together is what it was. No light falls outside the unit circle of direction sines. Returns s.
/// The same bytes for any number of threads. Throws as `scattered_energy`, and `Cancelled`.
double add_straylight(const Straylight& eye, const PixelGrid& grid, const Xyz& lamp_xyz,
                      int threads, const ProgressCallback& progress, XyzImage& pixels);

/// The mean of the CIE general equation over the square pixel of side `pitch_rad` around the
/// direction sines (x_rad, y_rad), which isn't the axis' own pixel.
double cie_pixel_mean(const Straylight& eye, double x_rad, double y_rad, double pitch_rad);

}  // namespace glare
