// The structure of an OpenEXR file of any kind, checked before OpenEXR sees it, as scan_lines.h
// does for one part of scan lines. Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace glare::openexr_io {

/// What an OpenEXR file takes.
struct PartStructure {
  std::uint64_t pixels = 0;         ///< Of the chosen part's data window.
  std::uint64_t decoder_bytes = 0;  ///< Memory that OpenEXR may need to read one part, at most.
};

/// Walks through all headers and blocks. Throws `image_io::BadImage` where the file is damaged or
/// cut short, or is smaller than its pixels can be compressed to; where there is no such part, or
/// it is of deep pixels. `threads` decode at a time.
PartStructure checked_parts(std::span<const std::byte> file, int part, int threads);

/// Whether the first header has the attribute that tells its part's type, of a checked file.
bool has_type_attribute(std::span<const std::byte> file);

}  // namespace glare::openexr_io
