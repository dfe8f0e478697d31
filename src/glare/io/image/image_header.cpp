#include "glare/io/image/image_header.h"

#include <algorithm>
#include <string>

#include "glare/base/error.h"

namespace glare::image_io {

using std::uint64_t;

namespace {

/// Of the file and its cleaned copy, the decoder, its floats, and the picture made of them.
uint64_t required_bytes(const Header& header, uint64_t file_bytes, uint64_t result_channels) {
  const uint64_t pixels = header.width * header.height;
  const uint64_t result_pixels = std::max(pixels, header.whole_pixels);
  return 2 * file_bytes + header.decoder_bytes + pixels * 4 * header.channels +
         result_pixels * 4 * result_channels;
}

}  // namespace

void require_sides(uint64_t width, uint64_t height) {
  require(width > 0 && height > 0, "the picture has no pixels");
  if (width <= kMaxSide && height <= kMaxSide) return;
  throw BadImage("says it is " + std::to_string(width) + " x " + std::to_string(height) +
                 " pixels; each side can be 65535 at most");
}

void require_fits(const Header& header, uint64_t file_bytes, uint64_t max_bytes,
                  uint64_t result_channels) {
  require_sides(header.width, header.height);
  require(header.channels > 0, "has no channels");
  require(file_bytes >= header.least_bytes, "has too little data for its size");
  const uint64_t needed = required_bytes(header, file_bytes, result_channels);
  if (needed > max_bytes) throw MemoryError(needed, max_bytes);
}

}  // namespace glare::image_io
