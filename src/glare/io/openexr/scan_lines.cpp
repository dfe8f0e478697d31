#include "glare/io/openexr/scan_lines.h"

#include <algorithm>
#include <set>
#include <string>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/image_header.h"
#include "glare/io/openexr/blocks.h"

namespace glare::openexr_io {

using image_io::BadImage;
using image_io::Reader;
using image_io::require;
using std::uint32_t;
using std::uint64_t;
using Bytes = std::span<const std::byte>;

namespace {

/// The parts of a header that say how large everything is.
struct Sizes {
  uint64_t width = 0;
  uint64_t height = 0;
  std::int64_t y_min = 0;
  uint64_t pixel_bytes = 0;  ///< Of all channels together.
  unsigned compression = 0;
};

void require_known_kind(uint32_t version) {
  constexpr uint32_t tiles = 0x200, long_names = 0x400, deep = 0x800, parts = 0x1000;
  require((version & 0xFF) == 2, "is of an unknown version of OpenEXR");
  require((version & tiles) == 0, "is tiled; scan lines were expected");
  require((version & deep) == 0, "holds deep pixels; plain ones were expected");
  require((version & parts) == 0, "has several parts; one was expected");
  require((version & ~(0xFFu | long_names)) == 0, "the header is damaged");
}

uint64_t pixel_bytes_of(Reader content) {
  uint64_t bytes = 0;
  while (!content.text_z().empty()) {
    const uint32_t type = content.u32();
    require(type <= 2, "has a channel of an unknown type");
    content.skip(4);
    require(content.i32() == 1 && content.i32() == 1, "has subsampled channels");
    bytes += type == 1 ? 2 : 4;
  }
  require(bytes > 0, "has no channels");
  return bytes;
}

void note_data_window(Reader content, Sizes& sizes) {
  const auto x_min = content.i32(), y_min = content.i32();
  const auto x_max = content.i32(), y_max = content.i32();
  constexpr auto most = static_cast<std::int64_t>(image_io::kMaxSide);
  require(x_min <= x_max && y_min <= y_max && x_max - x_min < most && y_max - y_min < most,
          "has a data window of an absurd size");
  sizes.width = static_cast<uint64_t>(x_max - x_min + 1);
  sizes.height = static_cast<uint64_t>(y_max - y_min + 1);
  sizes.y_min = y_min;
}

void note_attribute(const std::string& name, const std::string& type, Bytes value, Sizes& sizes) {
  Reader content(value);
  if (name == "channels" && type == "chlist") sizes.pixel_bytes = pixel_bytes_of(content);
  if (name == "compression" && type == "compression") sizes.compression = content.u8();
  if (name == "dataWindow" && type == "box2i") note_data_window(content, sizes);
  if (name == "chunkCount") require(content.u32() <= image_io::kMaxSide, "the header is damaged");
  if (type == "preview") {
    const uint64_t width = content.u32(), height = content.u32();
    require(width <= image_io::kMaxSide && height <= image_io::kMaxSide &&
                content.left() == width * height * 4,
            "the preview is damaged");
  }
}

/// Reads the header; every attribute lies within the file.
Sizes header_sizes(Reader& reader) {
  Sizes sizes;
  std::set<std::string> names;
  for (std::string name = reader.text_z(); !name.empty(); name = reader.text_z()) {
    const std::string type = reader.text_z();
    const Bytes value = reader.take(reader.u32());
    require(names.insert(name).second, "has an attribute twice");
    note_attribute(name, type, value, sizes);
  }
  require(sizes.width > 0 && sizes.pixel_bytes > 0 && names.contains("compression"),
          "the header is incomplete");
  return sizes;
}

/// The block must be what its place in the table says, and whole.
void require_block(Reader block, std::int64_t y, uint64_t raw_bytes, unsigned compression) {
  require(block.i32() == y, "a block of scan lines is damaged");
  require_whole_block(block.take(block.u32()), raw_bytes, compression);
}

void require_whole_blocks(Bytes file, Reader table, const Sizes& sizes) {
  const uint64_t rows = block_kind(sizes.compression).rows;
  for (uint64_t row = 0; row < sizes.height; row += rows) {
    Reader block(file);
    block.seek(table.number(8));
    const uint64_t rows_here = std::min(rows, sizes.height - row);
    require_block(block, sizes.y_min + static_cast<std::int64_t>(row),
                  sizes.width * rows_here * sizes.pixel_bytes, sizes.compression);
  }
}

}  // namespace

ScanLines checked_scan_lines(Bytes file) {
  Reader reader(file);
  require(file.size() >= 8 && reader.u32() == 20000630, "is not an OpenEXR file");
  require_known_kind(reader.u32());
  const Sizes sizes = header_sizes(reader);
  const BlockKind block = block_kind(sizes.compression);
  require(sizes.width * sizes.height * sizes.pixel_bytes / block.ratio <= file.size(),
          "has too little data for its size");
  require_whole_blocks(file, reader, sizes);
  // A block as it is stored, decompressed, in between, and what the methods keep beside it.
  return {sizes.width, sizes.height, 4 * block.rows * sizes.width * sizes.pixel_bytes};
}

}  // namespace glare::openexr_io
