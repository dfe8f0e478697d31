// The rays and rings that the plane is covered with. Internal.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "glare/diffraction/far_field.h"
#include "glare/integration/spectral_integral.h"

namespace glare {

/// A pixel's mean as a weighted sum of values at evenly spaced places across it and a little
/// beyond.
struct SubPixels {
  int per_pixel = 1;     ///< Places in a pixel's width.
  double pitch_rad = 0;  ///< From place to place; place 0 is the axis.
  int reach = 0;         ///< Places on either side of a pixel's centre that its mean takes in.
  std::vector<float> weights;  ///< 2 reach + 1.
};

/// As few places as the finest detail of the pattern allows.
SubPixels sub_pixels(const FarField& field, const PixelGrid& grid, const WavelengthRange& range);

/// Which of the two coordinates is the larger, the major one.
enum class Sector { x_major, y_major };

/// A ring of a sector of the half plane: the pixels whose major coordinate is `begin_px` to
/// `end_px` - 1 and whose minor coordinate is at most that, and at most `across_px`, either way
/// (pixels on the diagonals belong to the sector y_major). On
/// rays from the axis, along which minor / major is constant, another wavelength's pattern is the
/// same one shifted, over the logarithm of the major coordinate.
struct RayBand {
  Sector sector;
  int begin_px, end_px;
  int across_px;
  double first_rad, last_rad;  ///< Major coordinates that the pixels' means reach.
  double ray_step = 0;         ///< minor / major from ray to ray; ray 0 is the axis of coordinates.
  int rays_each_side = 0;
  bool near_axis = false;  ///< Where the pattern is steep.
  /// Steps of the logarithm at which the far field is interpolated, and how many of them make a
  /// step of the convolution.
  double fine_step = 0;
  int decimation = 1;
};

/// How far out the rings are from the axis, in pixels; closer in, interpolation would reach across
/// it. `light_width_nm` is the light's effective width.
int first_ring_px(const FarField& field, const SubPixels& sub, const WavelengthRange& range,
                  double light_width_nm);

/// The finest step of all bands, in which the lamp's spectrum must be known.
double finest_log_step(const FarField& field, const PixelGrid& grid, const SubPixels& sub,
                       const WavelengthRange& range);

/// Rings of about an octave each (the innermost up to a factor of three), of both sectors, from
/// `begin_px` to the grid's border, from the outermost on. Detail of more than `cutoff(bandwidth)`
/// cycles per unit of the logarithm may be neglected where the pattern has as much as `bandwidth`.
std::vector<RayBand> ray_bands(const FarField& field, const PixelGrid& grid, const SubPixels& sub,
                               const WavelengthRange& range, int begin_px,
                               const std::function<double(double)>& cutoff);

/// About as many values of rays, X, Y and Z, are held at a time.
inline constexpr double kMostRayValues = 16e6;

/// An upper bound for the memory that the rings take at a time, in bytes, for an open part whose
/// longer side is `open_side_mm`.
std::uint64_t ring_bytes(double open_side_mm, const PixelGrid& grid, const WavelengthRange& range,
                         int threads);

}  // namespace glare
