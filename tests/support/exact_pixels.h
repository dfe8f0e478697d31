// The glare template by its definition at chosen pixels, for pictures too large for
// `exact::xyz`: thousands of pixels of a 4096 x 4096 template in seconds. Like it, in double
// precision and apart from the library's own diffraction, with which it shares no code.
//
// The intensity is the Fourier sum over the aperture's autocorrelation, which has no end at any
// frequency; so a Kaiser-Bessel gridding finds it between the frequencies of one fast transform to
// 1e-12 of what is around it, and the pixel's mean with it: only the wavelengths are a quadrature.
#pragma once

#include <vector>

#include "glare/aperture/aperture.h"
#include "glare/color/matrix.h"
#include "support/exact_template.h"

namespace glare::exact {

/// Column and row of a pixel.
struct Pixel {
  int x = 0;
  int y = 0;

  friend auto operator<=>(const Pixel&, const Pixel&) = default;
};

struct PixelRequest {
  int width = 0;              ///< Of the whole template, in pixels.
  int height = 0;             ///< Of the whole template, in pixels.
  double pitch_rad = 0;       ///< Direction sine from pixel to pixel.
  std::vector<Pixel> pixels;  ///< To compute, in the result's order.
  double lambda_lo_nm = 0;    ///< The wavelength integrals run from here
  double lambda_hi_nm = 0;    ///< to here.
  /// How far, at most, the phase between the aperture's opposite corners moves from one wavelength
  /// to the next. Four-point Gauss-Legendre on parts that no knot of a table falls into.
  double radians_per_wavelength = 0.5;
  int threads = 0;  ///< 0: as many as the machine has. The result does not depend on it.
};

struct PixelResult {
  std::vector<std::vector<Xyz>> xyz;  ///< By lamp, then by pixel; per steradian, as `exact::xyz`.
  int fewest_wavelengths = 0;         ///< That a pixel was summed over.
  int most_wavelengths = 0;
};

/// What `exact::xyz` computes, at chosen pixels. Throws `std::invalid_argument` where nothing gets
/// through the aperture, a pixel lies outside the template, or a lamp has no luminance. Takes
/// about 20 bytes for each of (4 N)^2 frequencies, N the aperture's side in samples.
PixelResult xyz_at(const Aperture& aperture, const PixelRequest& request, const Observer& observer,
                   const std::vector<SpectralTable>& lamps);

/// About `count` different pixels, evenly spread over the angle and the logarithm of the distance
/// from the axis, from `inner_px` to `outer_px` or the template's border. Near the axis, where
/// there aren't that many pixels, fewer. Always the same ones.
std::vector<Pixel> spread_pixels(int width, int height, int count, double inner_px,
                                 double outer_px);

}  // namespace glare::exact
