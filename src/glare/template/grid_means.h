// A picture's means over the pixels of another grid. Internal.
#pragma once

#include "glare/base/image.h"

namespace glare {

/// A new grid's pixels along one axis, as old pixels see them. The old picture's axis is the centre
/// of its pixel (size / 2).
struct GridAxis {
  int pixels = 1;          ///< New ones, at least 1.
  double pitch_ratio = 1;  ///< The new pitch over the old one, above 0.
  double shift_px = 0;  ///< From the centre of new pixel (pixels / 2) to the axis, in new pixels.
};

/// The mean of a picture of pixels' means over each rectangle of another grid, 0 beyond the
/// picture. Each old pixel keeps its light, which is spread in it so that it goes smoothly over
/// into its neighbours' (first in its row, then in its column): the sum of the values times the
/// pixels' area is the same, but for what falls beyond the new borders, and at a ratio of 1 without
/// a shift so is each value. Where no old value is negative, no new one is. Takes beside the result
/// one picture of the new width and the old height. The same bytes for any number of threads.
///
/// Along an axis the light before a place is a cubic in each pixel, given at the pixels' ends and
/// with the densities there: those of fourth order, (7 (b + c) - (a + d)) / 12 between pixels b and
/// c (Colella and Woodward 1984, eq. 1.9), but not beyond b, c, or twice the smaller of them, and 0
/// between different signs. Up to three times the smaller, the cubic is monotone (Fritsch and
/// Carlson 1980), so that densities keep their sign; twice follows a bright core that is narrower
/// than a pixel better.
Image<float> grid_means(const Image<float>& picture, const GridAxis& across, const GridAxis& down,
                        int threads = 0);

}  // namespace glare
