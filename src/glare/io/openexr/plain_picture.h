// A colour picture as an OpenEXR file of its own. Internal.
#pragma once

#include <filesystem>

#include "glare/io/picture_document.h"

namespace glare::openexr_io {

/// Scan lines of 32-bit floats, ZIP, with chromaticities. Throws `OutputError`, `Cancelled`.
void write_plain_picture(const std::filesystem::path& path, const Picture& picture,
                         double pixel_aspect, const PictureWriting& options);

}  // namespace glare::openexr_io
