// Fraunhofer diffraction: the far field of an aperture, one for every wavelength.
#pragma once

#include <array>
#include <cstdint>

#include "glare/aperture/aperture.h"
#include "glare/base/image.h"
#include "glare/base/progress.h"

namespace glare {

/// What of the far field is wanted, and how finely it must be sampled.
struct FarFieldRequest {
  /// Largest spatial frequencies |f| = |theta| / lambda that will be asked for, in cycles per mm.
  double max_frequency_x_per_mm = 0;
  double max_frequency_y_per_mm = 0;
  /// How far the half plane kx >= 0 that is held is to reach across the axis, in cycles per mm.
  double overlap_frequency_x_per_mm = 0;
  /// The transform's length over that of the aperture's open part, at least 2, the critical
  /// sampling of the intensity; 4 is good for interpolation. Lengths are rounded up to fast ones.
  double padding = 4;
  int threads = 0;  ///< 0: as many as the machine has.
  ProgressCallback progress;
};

/// The normalised intensity of the far field over spatial frequency f = theta / lambda,
///   I(f) = |T(f)|^2 / (integral of t(x)^2 dx),  T(f) = integral of t(x) exp(-2 pi i x.f) dx,
/// in mm^2, so that PSF(theta, lambda) = I(theta / lambda) / lambda^2 per steradian (lambda in mm).
/// It is sampled at the frequencies (kx bin_x, ky bin_y); since t is real, I(-f) = I(f), and of the
/// half plane kx < 0 only as much is held as interpolation near the axis needs.
struct FarField {
  /// Row r, column c: the sample at kx = r + first_kx, ky = c + first_ky.
  Image<float> intensity_mm2;
  bool odd = false;  ///< I(-f) = -I(f) instead: a part of another intensity.
  int first_kx = 0;
  int first_ky = 0;
  double bin_x_per_mm = 0;
  double bin_y_per_mm = 0;
  /// Size of the rectangle that holds all of the aperture's open part. The intensity has no detail
  /// finer than 1 / extent.
  double extent_x_mm = 0;
  double extent_y_mm = 0;
  /// Of the aperture it comes from.
  double aperture_pixel_mm = 0;
  double aperture_width_mm = 0;
  double energy_area_mm2 = 0;
};

/// Samples that are held beyond the largest frequencies asked for, for interpolation.
inline constexpr int kFarFieldMargin = 32;

/// The far field of an aperture. Where it stands in the picture makes no difference. Frequencies
/// beyond 1 / (2 pixel) repeat those within it, since the aperture is sampled. Throws `InputError`
/// for an aperture that isn't valid, `Cancelled` when the callback says stop.
FarField far_field(const Aperture& aperture, const FarFieldRequest& request);

/// Bytes that `far_field` takes at its peak, besides the aperture, for an open part of `width` x
/// `height` samples.
std::uint64_t far_field_bytes(int width, int height, double pixel_mm,
                              const FarFieldRequest& request);

/// The lengths of the transforms that `far_field` then does, along the rows and the columns: what
/// `measure_transforms` takes.
std::array<int, 2> far_field_transform_lengths(int width, int height, double pixel_mm,
                                               const FarFieldRequest& request);

}  // namespace glare
