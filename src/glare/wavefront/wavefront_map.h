// The wavefront error over an aperture's samples. Internal.
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "glare/aperture/aperture.h"
#include "glare/aperture/open_part.h"
#include "glare/base/image.h"
#include "glare/spectrum/spectrum.h"
#include "glare/wavefront/aberrations.h"

namespace glare {

/// Where an aperture's samples are: right and up from the pupil's centre.
class PupilGrid {
 public:
  PupilGrid(const Aperture& aperture, const PupilPlace& pupil_center)
      : pixel_mm_(aperture.pixel_mm()),
        x0_mm_((0.5 - 0.5 * aperture.transmittance.width()) * pixel_mm_ - pupil_center.x_mm),
        y0_mm_((0.5 * aperture.transmittance.height() - 0.5) * pixel_mm_ - pupil_center.y_mm) {}

  double x_mm(int x) const { return x0_mm_ + x * pixel_mm_; }
  double y_mm(int y) const { return y0_mm_ - y * pixel_mm_; }

 private:
  double pixel_mm_, x0_mm_, y0_mm_;
};

/// The light in an aperture's open part: t exp(2 pi i W / lambda), and how fast its phase changes
/// with place and wavelength. W is kept for the wavelength in focus; of another it differs by a
/// multiple of |x|^2.
class WavefrontMap {
 public:
  /// Keeps both by reference. Throws `OptionError` where the aperture is open beyond the diameter
  /// that the Zernike polynomials are for.
  WavefrontMap(const Aperture& aperture, const Aberrations& aberrations, int threads);

  const OpenPart& part() const { return part_; }

  /// Row y of the open part, at a wavelength: part().width values.
  void amplitude_row(int y, double wavelength_nm, std::span<std::complex<float>> result) const;

  /// How far the phases of two places move apart from one wavelength to another, at most, in rad:
  /// over a few thousand of the open samples.
  double phase_spread_rad(double from_nm, double to_nm) const;

  /// The largest phase step between neighbouring open samples at either end of a range, in rad.
  double largest_phase_step_rad(const WavelengthRange& range) const;

  /// Bytes that a map of that many samples takes.
  static std::uint64_t bytes(int width, int height);

 private:
  struct Sample {
    double path_um;  ///< W in focus.
    double path_um_per_dioptre;
  };
  void require_within_zernike_pupil() const;
  double squared_distance_mm2(int x, int y) const;
  void collect_samples();
  double largest_step_um(double dioptre) const;

  const Aperture& aperture_;
  const Aberrations& aberrations_;
  PupilGrid grid_;
  OpenPart part_;
  Image<float> path_um_;  ///< Of the open part, in focus.
  std::vector<Sample> samples_;
};

/// The steepest slope of W at a distance of up to `radius_mm` from the pupil's centre and any
/// wavelength of the range, in rad of direction.
double steepest_slope_rad(const Aberrations& aberrations, double radius_mm,
                          const WavelengthRange& range);

}  // namespace glare
