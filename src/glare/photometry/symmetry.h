// From the part of the sphere that a file holds to the whole. Internal.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "glare/base/image.h"
#include "glare/photometry/photometric_data.h"

namespace glare::photometry {

/// Intensities at angles: `candela(i, j)` at `horizontal_deg[i]`, `vertical_deg[j]`.
struct MeasuredGrid {
  std::vector<double> horizontal_deg, vertical_deg;
  Image<float> candela;
};

/// Angles that differ by less are one: files have two decimals, sometimes rounded.
inline constexpr double kSameAngle_deg = 0.01;
bool same_angle(double a_deg, double b_deg);

/// What is one with a multiple of 90 degrees becomes that.
void snap_to_right_angles(std::vector<double>& angles_deg);

/// An image for the intensities at the grid's angles, which `text_size` characters are to hold.
/// Throws `InputError`, before it takes the memory, where they can't: a number takes one at least.
Image<float> room_for_intensities(const MeasuredGrid& grid, std::size_t text_size,
                                  const std::string& place);

/// The distribution; what is wrong with the grid is told with this place.
LuminousIntensityDistribution distribution_from(PhotometricType type, const MeasuredGrid& grid,
                                                const std::string& place);

/// Whether the angles go around the whole circle.
bool is_closed(const MeasuredGrid& grid);

/// The grid and its mirror image about its last horizontal angle.
MeasuredGrid mirrored_about_last(const MeasuredGrid& grid);

/// The grid and its mirror image about its first horizontal angle.
MeasuredGrid mirrored_about_first(const MeasuredGrid& grid);

/// One plane for all C: twice, at 0 and at 360.
MeasuredGrid around_the_axis(const MeasuredGrid& grid);

/// With the first plane again, 360 degrees further.
MeasuredGrid closed_circle(const MeasuredGrid& grid);

/// A closed circle from 0 to 360, where one of its angles is a multiple of 360; else as it is.
MeasuredGrid from_zero(const MeasuredGrid& grid);

struct Unfolded {
  MeasuredGrid grid;
  PhotometricSymmetry symmetry;
  bool was_open = false;  ///< A circle that ended one step before 360 was closed.
};

/// Type C by the range of its planes, after LM-63: one; 90 degrees from a multiple of 90 on, to be
/// mirrored twice; 180 from a multiple of 90 on, to be mirrored once; 360; and, though no standard
/// has that, 360 less the last step. Throws `InputError`, without a place, for others.
Unfolded unfolded_type_c(const MeasuredGrid& grid);

/// Type A and B: H from 0 on, up to 180, is mirrored; others are as they are.
Unfolded unfolded_type_ab(const MeasuredGrid& grid);

}  // namespace glare::photometry
