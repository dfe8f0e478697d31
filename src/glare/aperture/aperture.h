// The aperture: what of the light's amplitude gets through at each place of the pupil's plane.
#pragma once

#include <optional>

#include "glare/base/image.h"

namespace glare {

/// Amplitude transmittance t(x) sampled on a square grid of `width_mm / width` in the pupil's
/// plane; 0 is opaque, 1 is open. A pixel is a sample, at the pixel's centre.
struct Aperture {
  Image<float> transmittance;  ///< Each value in [0, 1], unless band-limited.
  double width_mm = 0;         ///< Physical width of the whole picture, > 0.

  /// Set where the samples are of a transmittance whose frequencies beyond the samples' reach were
  /// taken away: what it was before is in [0, 1] and has this integral of t(x)^2, in mm^2; the
  /// samples waver a little around it near edges, and are in [-0.5, 1.5]. The far field, within
  /// the reach, is that of the transmittance before.
  std::optional<double> unlimited_energy_area_mm2 = {};

  /// Distance between neighbouring samples, both ways.
  double pixel_mm() const { return width_mm / transmittance.width(); }
  double height_mm() const { return pixel_mm() * transmittance.height(); }
};

/// The integral of t(x)^2 over the plane: the area through which energy passes, in mm^2; before
/// band-limiting.
double energy_area_mm2(const Aperture& aperture);

/// Throws `InputError` unless the aperture has at least 2 x 2 samples, a positive finite width,
/// every transmittance finite and in its range, and some light gets through.
void require_valid(const Aperture& aperture);

/// The two masks one behind the other: the product of their transmittances, on the finer of the
/// two grids; the coarser one is interpolated to it. Both cover the same physical rectangle, and
/// neither is band-limited. Throws `InputError` where their shapes (width : height) or physical
/// widths differ.
Aperture stacked(const Aperture& front, const Aperture& behind);

/// `image` brought to `width` x `height` samples over the same rectangle, by a windowed-sinc
/// interpolation limited to [0, 1]. Both sizes are at least those of `image`.
Image<float> enlarged(const Image<float>& image, int width, int height);

}  // namespace glare
