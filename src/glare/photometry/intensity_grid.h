// A distribution on a grid of equal steps of H and V: the form of an image.
#pragma once

#include <array>

#include "glare/base/progress.h"
#include "glare/photometry/luminous_intensity.h"

namespace glare {

/// Places in H and V of type A, in degrees. The first and last of `width` columns are at the ends
/// of `h_deg`, the rows likewise: 101 columns from -50 to 50 are 1 degree apart.
struct IntensityGrid {
  std::array<double, 2> h_deg{-90, 90}, v_deg{-90, 90};
  int width = 181, height = 181;
};

/// Throws `OptionError` for ranges that don't ascend, aren't finite, span more than 360 degrees of
/// H or leave -360 to 720 (H) or -90 to 90 (V), and for sides outside 2 to 65535.
void require_intensity_grid(const IntensityGrid& grid);

/// The distribution as type A on the grid: at each place the intensity towards that direction of
/// the vehicle. `threads`: 0 for as many as the machine has. Throws `OptionError` as above,
/// `Cancelled` where `progress` says stop.
LuminousIntensityDistribution on_grid(const LuminousIntensityDistribution& distribution,
                                      const IntensityGrid& grid, const Mounting& mounting = {},
                                      int threads = 0, const ProgressCallback& progress = {});

/// Type A from a picture of candela on the grid, whose first row is the top, at the largest V.
/// Throws `OptionError` as above, `InputError` for intensities that aren't.
LuminousIntensityDistribution distribution_from_image(const Image<float>& candela,
                                                      const IntensityGrid& grid);

/// The picture of a type A distribution, whose first row is the top.
Image<float> image_from_distribution(const LuminousIntensityDistribution& distribution);

}  // namespace glare
