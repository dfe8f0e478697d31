// The glare template by its definition, with no fast transform and no approximation but a
// quadrature over wavelength that can be refined at will. Slow, for tests: what the library
// computes is compared with it, so it shares no code with the library's own diffraction.
#pragma once

#include <array>
#include <vector>

#include "glare/aperture/aperture.h"
#include "glare/base/image.h"
#include "glare/color/matrix.h"

namespace glare::exact {

/// A function of wavelength: linear between its samples and 0 outside them. Wavelengths ascend.
struct SpectralTable {
  std::vector<double> wavelength_nm;
  std::vector<double> value;
};

/// x-bar, y-bar and z-bar.
using Observer = std::array<SpectralTable, 3>;

/// The value of `table` at a wavelength.
double value_at(const SpectralTable& table, double wavelength_nm);

/// Which pixels to compute, and over which wavelengths. Pixel (i, j) of the template is the
/// square of side `pitch_rad()` centred on ((i - width / 2) pitch, (j - height / 2) pitch).
struct Request {
  int width = 0;            ///< Of the whole template, in pixels; every column is computed.
  int height = 0;           ///< Of the whole template, in pixels.
  double fov_deg = 0;       ///< Across `width`; degrees stand for direction sines (deg * pi / 180).
  std::vector<int> rows;    ///< The rows of the template to compute, in the result's order.
  double lambda_lo_nm = 0;  ///< The wavelength integrals run from here
  double lambda_hi_nm = 0;  ///< to here. Neither is used by `psf`.
  int refine = 1;           ///< Each quadrature interval (at most 1 nm) is cut into so many parts.
  int threads = 0;          ///< 0: as many as the machine has. The result does not depend on it.

  double pitch_rad() const;
};

/// The monochromatic point spread function in one direction, per steradian:
///   PSF(theta, lambda) = |T(theta / lambda)|^2 / (lambda^2 A),
///   T(f) = p^2 sum t(x) exp(-2 pi i x.f),   A = p^2 sum t(x)^2,
/// where p is the distance between samples and x runs over them. The sum itself, term by term.
double psf_point(const Aperture& aperture, double theta_x, double theta_y, double wavelength_nm);

/// The mean of `psf_point` over the square of each requested pixel: width x rows.size(), per
/// steradian. Exact but for rounding, below 1e-15 of the pattern's peak.
Image<double> psf(const Aperture& aperture, const Request& request, double wavelength_nm);

/// The template of each lamp, width x rows.size(), per steradian:
///   XYZ(theta) = integral PSF S (x, y, z) dlambda / integral S y dlambda.
/// Two-point Gauss-Legendre on every interval between neighbouring whole nanometres and knots of
/// the tables, cut further into `refine` parts. Throws `std::invalid_argument` where nothing gets
/// through the aperture, a row lies outside the template, or a lamp has no luminance.
std::vector<Image<Xyz>> xyz(const Aperture& aperture, const Request& request,
                            const Observer& observer, const std::vector<SpectralTable>& lamps);

/// The lamp's own colour over a range of wavelengths, at Y = 1.
Xyz lamp_xyz(const Observer& observer, const SpectralTable& lamp, double lambda_lo_nm,
             double lambda_hi_nm);

}  // namespace glare::exact
