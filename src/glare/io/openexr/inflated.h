// How long deflated data are when they are inflated. OpenEXR takes shorter ones for whole blocks,
// and leaves the rest of their pixels unset. Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace glare::openexr_io {

/// Throws `image_io::BadImage` unless the data are a zlib stream of `size` bytes.
void require_inflates_to(std::span<const std::byte> data, std::uint64_t size);

/// Inflates the data to `result`. Throws unless they just fill it.
void inflate_to(std::span<const std::byte> data, std::span<std::byte> result);

}  // namespace glare::openexr_io
