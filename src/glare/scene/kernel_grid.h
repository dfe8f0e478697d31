// A template's veil on a grid from which pictures' pixels are summed. Internal.
#pragma once

#include <vector>

#include "glare/base/aligned_memory.h"
#include "glare/color/matrix.h"
#include "glare/template/glare_template.h"

namespace glare {

/// Values in cd/m^2 per lux, four floats (R, G, B of a picture's space, and 0) a pixel, with
/// kBorder pixels of 0 around them.
///
/// The veil between them is each pixel's square widened by `softness` of itself: 0 leaves the
/// squares as they are, 1 is linear from pixel to pixel. Whatever it is, the light is the pixels'.
struct KernelGrid {
  static constexpr int kBorder = 8;  ///< As many columns and rows as a picture's pixel overlaps.
  /// The widest picture's pixel, in pixels of the grid, for softness 0; less by softness.
  static constexpr double kWidestPixel = 7;

  int width = 0, height = 0;                         ///< With the borders.
  double axis_column = 0, axis_row = 0;              ///< Of the pixel whose centre is the axis.
  double pitch_rad = 0;                              ///< Direction sine from pixel to pixel.
  double softness = 0;                               ///< 0 to 1.
  std::vector<float, AlignedAllocator<float>> rgba;  ///< width * height * 4.
};

/// The template within `reach` (direction sine) of its axis, across and down, at `pitch_rad` where
/// that is coarser than its own, by means over squares; else at its own.
KernelGrid kernel_grid(const GlareTemplate& glare_template, const Matrix3& picture_from_template,
                       double pitch_rad, double reach, double softness);

}  // namespace glare
