// One channel and OpenEXR's scan lines. Internal.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <filesystem>
#include <functional>

#include "glare/base/image.h"

namespace glare::openexr_io {

/// A header of this size with ZIP compression, one channel, Y, of 32-bit floats, and the name of
/// this software.
Imf::Header gray_header(int width, int height);

/// Writes a file with this header, of `gray_header`, and these values, all or nothing. Throws
/// `OutputError`, and `Cancelled` where `keep_going` says false.
void write_gray_file(const std::filesystem::path& path, const Imf::Header& header,
                     const Image<float>& values, const std::function<bool()>& keep_going);

}  // namespace glare::openexr_io
