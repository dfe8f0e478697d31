// The pupil's outline. Internal.
#pragma once

#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye.h"

namespace glare {

/// The outline of the pupil when it is `diameter_mm` wide: its shape scaled, its centre as it is.
/// The polygon's area is pi diameter^2 / 4; its sagittas are below 0.01 um.
std::vector<Point> pupil_outline(const PupilParameters& parameters, std::uint64_t seed,
                                 double diameter_mm);

/// The farthest, right or left, up or down, that an outline of any seed reaches from the axis.
double pupil_reach_mm(const PupilParameters& parameters, double diameter_mm);

}  // namespace glare
