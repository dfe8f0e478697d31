// What the eye's optics do to the light besides cutting it off: aberrations, and the retina's
// preference for light through the middle of the pupil.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glare/aperture/aperture.h"
#include "glare/wavefront/zernike.h"

namespace glare {

/// A place in the pupil's plane, from the pupil's centre: right and up in the aperture's picture,
/// as OSA/ANSI has it.
struct PupilPlace {
  double x_mm = 0;
  double y_mm = 0;
};

/// A wavefront error as Zernike polynomials over a pupil of a stated diameter.
struct ZernikeWavefront {
  double pupil_diameter_mm = 0;                  ///< 0.1 to 50 where there are coefficients.
  std::vector<ZernikeCoefficient> coefficients;  ///< Each at most 1000 um; no j twice.
};

/// The Stiles-Crawford effect of the first kind: light that passes the pupil at the distance r from
/// the peak counts 10^(-rho r^2) as much (Applegate and Lakshminarayanan 1993: rho about 0.05).
struct StilesCrawford {
  double rho_per_mm2 = 0.05;  ///< 0 to 1.
  PupilPlace peak;            ///< At most 10 mm off the centre.
};

/// The eye's optics. The default is none of it. The sign convention is that of prescriptions and of
/// OSA/ANSI: light of wavelength lambda gets the phase 2 pi W / lambda,
///   W(x, lambda) = -(defocus + chromatic difference(lambda)) |x|^2 / 2 + Zernike sum,
/// in um with x in mm and dioptres; light through x then comes from the direction gradient of W
/// (um per mm is mrad), so the blur of a short-sighted eye (negative defocus) shows the pupil
/// upright.
struct Aberrations {
  double defocus_dioptre = 0;  ///< Refractive error, negative: short-sighted. At most 50.
  ZernikeWavefront zernike;
  bool chromatic = false;   ///< With the longitudinal chromatic aberration of the chromatic eye.
  double focused_nm = 589;  ///< The wavelength at which that is 0; 300 to 1000.
  std::optional<StilesCrawford> stiles_crawford;
  /// Where the pupil's centre is, from the middle of the aperture's picture.
  PupilPlace pupil_center;

  /// True where W isn't 0 (or constant, which changes nothing).
  bool has_phase() const;
  bool empty() const { return !has_phase() && !stiles_crawford; }
};

/// Throws `OptionError` for numbers outside their ranges.
void require_valid(const Aberrations& aberrations);

/// The refractive error of the chromatic eye, in dioptres: p - q / (lambda - c), p = 1.68524,
/// q = 633.46, c = 214.102 nm; nearly 0 at 589 nm. Thibos, Ye, Zhang, Bradley: The chromatic eye.
/// Applied Optics 31 (1992). `wavelength_nm` is above c.
double chromatic_refraction_dioptre(double wavelength_nm);

/// All of the aberrations that depend on wavelength, as refractive error in dioptres, 0 at
/// `focused_nm`; the defocus is not among them.
double chromatic_difference_dioptre(const Aberrations& aberrations, double wavelength_nm);

/// The optical path difference W at a place of the pupil, in um.
double optical_path_um(const Aberrations& aberrations, const PupilPlace& place,
                       double wavelength_nm);

/// The aperture as the retina weighs it: its transmittance times sqrt(10^(-rho r^2)), the amplitude
/// that belongs to that efficiency.
Aperture apodized(Aperture aperture, const StilesCrawford& effect, const PupilPlace& pupil_center);

/// What there is, on one line; empty where there is nothing.
std::string to_string(const Aberrations& aberrations);

}  // namespace glare
