// The colour spaces that need no config. Internal.
#pragma once

#include <vector>

#include "glare/color/color_space.h"

namespace glare {

/// CIE XYZ, and the spaces of data/color/make_config.py, whose white isn't adapted: in the order in
/// which a person is told them.
const std::vector<RgbColorSpace>& built_in_color_spaces();

/// ACES2065-1 with white adapted to D65 (Bradford), from CIE XYZ: what the role `aces_interchange`
/// means in configs (OpenColorIO's UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD, inverted).
Matrix3 aces_interchange_from_xyz();

}  // namespace glare
