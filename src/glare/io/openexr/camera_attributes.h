// What the attributes of an OpenEXR file tell of the camera. Internal.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <optional>

#include "glare/io/picture_document.h"

namespace glare::openexr_io {

/// The angle from pixel to pixel at the centre of the picture, from the first of these attributes
/// that are there and plausible; nothing where there are none.
std::optional<ToldPixelPitch> told_pixel_pitch(const Imf::Header& header);

}  // namespace glare::openexr_io
