// How far chosen pixels of a picture are from the exact reference.
#pragma once

#include <vector>

#include "glare/integration/spectral_integral.h"
#include "support/exact_pixels.h"

namespace glare::test {

/// The value below which that share of the values lies; the values are at least one.
double percentile(std::vector<double> values, double share);

/// Relative errors of luminance, and CIEDE2000 with each pixel scaled to its own luminance, of
/// `found` at the pixels whose exact XYZ are `expected`. Every pixel counts, however dark.
struct PixelErrors {
  std::vector<double> luminance, delta_e;

  PixelErrors(const XyzImage& found, const std::vector<exact::Pixel>& pixels,
              const std::vector<Xyz>& expected);
};

}  // namespace glare::test
