// A picture in the caller's memory. Internal.
#pragma once

#include <array>
#include <cstddef>

#include "glare/base/image.h"
#include "glare/glare_c.h"

namespace glare::c {

/// Throws `OptionError` where a size or stride can't be or a place lies outside the buffer.
void require_valid(const glare_pixels& pixels);

/// The pixels as three channels, and back; grey ones are three times the same, of which the first
/// goes back. The pixels are valid, and the channels of their size.
std::array<Image<float>, 3> channels_from(const glare_pixels& pixels);
void copy_channels(const std::array<Image<float>, 3>& channels, const glare_pixels& pixels);

}  // namespace glare::c
