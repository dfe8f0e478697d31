// A lamp's veil along a picture's row: the inner loop, compiled for several instruction sets, of
// which the best that the machine has is taken when the program runs. Internal.
#pragma once

#include <array>

#include "glare/scene/kernel_grid.h"

namespace glare {

/// A number along a row of places: at place i, start + i * step; a row below it is `below` more.
struct AlongRow {
  double start = 0, step = 0, below = 0;
};

/// Square pixels of one row of a perspective picture, and where they lie about a lamp.
struct VeilRow {
  AlongRow right;    ///< Tangent to the right of the picture's axis.
  AlongRow down;     ///< Tangent below it.
  AlongRow column;   ///< Direction sine to the lamp's right, times the length of (right, down, 1),
  AlongRow row;      ///< and below the lamp; both in pixels of the grid.
  AlongRow forward;  ///< Cosine of the angle to the lamp, times that length.
};

/// channels[k][i] += illuminance_lux * the veil's mean over pixel i, for i < count. The pixel is
/// taken for the rectangle in the grid that has its middle and, each way, its variance; those that
/// the veil doesn't reach are left as they are.
void add_veil(const KernelGrid& grid, const VeilRow& pixels, int count, float illuminance_lux,
              const std::array<float*, 3>& channels);

}  // namespace glare
