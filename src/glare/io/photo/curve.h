// Drawing a smooth closed curve by area. Internal.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glare/base/image.h"

namespace glare::photo {

using Place = std::array<double, 2>;

/// The closed Catmull-Rom curve through `points`, with `parts` straight pieces between two of them.
std::vector<Place> smooth_closed_curve(std::span<const Place> points, int parts);

/// The share of each pixel that lies within the closed polygon, exactly; pixel (0, 0) covers 0 to 1
/// both ways. The sense of the polygon doesn't matter.
Image<float> covered_area(std::span<const Place> polygon, int width, int height);

}  // namespace glare::photo
