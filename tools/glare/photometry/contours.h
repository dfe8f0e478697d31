// Lines of equal value through a grid of values.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glare/base/image.h"

namespace glare::tool {

/// The points of a line, in the order in which it is drawn; a closed one ends where it begins.
using ContourLine = std::vector<std::array<double, 2>>;

/// The lines on which values reach a level, by marching squares: `values(i, j)` are at `x[i]`,
/// `y[j]`, linear along each edge of the grid; where a cell's corners alternate, their mean
/// decides. A value that equals the level lies inside. The same lines in the same order each time.
std::vector<ContourLine> contour_lines(std::span<const double> x, std::span<const double> y,
                                       const Image<float>& values, double level);

}  // namespace glare::tool
