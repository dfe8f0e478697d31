// Blocks of pixels as OpenEXR compresses them: scan lines, or a tile. Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace glare::openexr_io {

struct BlockKind {
  std::uint64_t rows = 0;   ///< Scan lines that are compressed together.
  std::uint64_t ratio = 0;  ///< How much smaller a block can get, at most.
};

/// Of the compression with this number. Throws `image_io::BadImage` where it is unknown.
BlockKind block_kind(unsigned compression);

/// Requires that the stored data of a block can be that of `raw_bytes` of pixels: OpenEXR leaves
/// pixels unset where there are fewer. (Data that aren't smaller than the pixels are the pixels
/// themselves; deflated data have a checksum.) Throws `image_io::BadImage`.
void require_whole_block(std::span<const std::byte> data, std::uint64_t raw_bytes,
                         unsigned compression);

}  // namespace glare::openexr_io
