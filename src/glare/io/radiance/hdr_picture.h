// Whole Radiance pictures. Internal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>

#include "glare/io/image/byte_reader.h"
#include "glare/io/radiance/hdr_header.h"
#include "glare/picture/picture.h"

namespace glare::radiance_io {

struct HdrPicture {
  HdrHeader header;
  Picture picture;
};

/// Throws `image_io::BadImage`, also for rows in another order than from the top left (-Y +X);
/// `MemoryError`.
HdrPicture read_hdr_picture(image_io::Bytes file, std::uint64_t max_bytes);

/// Writes a picture behind these lines, all or nothing; it is in their colour space. Returns how
/// many pixels had values that the code can't hold. Throws `OutputError`, `Cancelled`.
std::uint64_t write_hdr_picture(const std::filesystem::path& path, const HdrHeader& header,
                                const Picture& picture, const std::function<bool()>& keep_going);

}  // namespace glare::radiance_io
