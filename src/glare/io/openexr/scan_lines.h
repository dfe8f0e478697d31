// The structure of an OpenEXR file of scan lines, checked before OpenEXR sees it: OpenEXR takes
// memory as the header says, and leaves pixels unset where a block is shorter than it should be.
// Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace glare::openexr_io {

/// What an OpenEXR file holds.
struct ScanLines {
  std::uint64_t width = 0;  ///< Of the data window, 1 to 65535.
  std::uint64_t height = 0;
  std::uint64_t decoder_bytes = 0;  ///< Memory that OpenEXR may need to read it, at most.
};

/// Walks through the header and all the blocks of scan lines. Throws `image_io::BadImage` where the
/// file is no OpenEXR file or of tiles, several parts or deep pixels; where it has subsampled
/// channels, is damaged or cut short, or is smaller than its pixels can be compressed to.
/// (A forged block that inflates to less than it should, with the right checksum, isn't noticed.)
ScanLines checked_scan_lines(std::span<const std::byte> file);

}  // namespace glare::openexr_io
