// The colour space that the chromaticities in a file make. Internal.
#pragma once

#include <array>
#include <string>

#include "glare/color/color_space.h"

namespace glare {

/// Of red, green, blue and white.
using FileChromaticities = std::array<Chromaticity, 4>;

/// The built-in space with these chromaticities, of that name where one is given; else one of that
/// name, or "custom". Throws `image_io::BadImage` where they make none.
RgbColorSpace color_space_with(const FileChromaticities& chromaticities,
                               const std::string& name = "");

/// What the space's matrix implies.
FileChromaticities chromaticities_of(const RgbColorSpace& space);

}  // namespace glare
