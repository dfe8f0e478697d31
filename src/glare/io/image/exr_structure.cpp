// The headers of an OpenEXR file. The library takes windows, tables and tiles to be as large as the
// header says, and parses attributes of any kind. So the windows are bounded by the bytes that are
// there, and attributes that do not matter for the pixels are blanked.
#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/structure.h"

namespace glare::image_io {

using std::uint32_t;
using std::uint64_t;

namespace {

struct ExrBox {
  std::int64_t x_min = 0, y_min = 0, x_max = -1, y_max = -1;
  uint64_t width() const {
    return static_cast<uint64_t>(std::max<std::int64_t>(x_max - x_min + 1, 0));
  }
  uint64_t height() const {
    return static_cast<uint64_t>(std::max<std::int64_t>(y_max - y_min + 1, 0));
  }
};

struct ExrPart {
  ExrBox data_window, display_window;
  uint64_t channels = 0;
  uint64_t pixel_bytes = 0;
  unsigned compression = 0;
  uint64_t chunk_count = 0;  ///< As stated; 0 if it is not.
  uint64_t tile_width = 0, tile_height = 0;
};

void require_exr_channels(Reader content, ExrPart& part) {
  while (!content.text_z().empty()) {
    const uint32_t type = content.u32();
    require(type <= 2, "has a channel of an unknown type");
    require(type != 0, "has a channel of whole numbers (identities, not light)");
    content.skip(4);
    require(content.i32() == 1 && content.i32() == 1, "has subsampled channels");
    part.pixel_bytes += type == 1 ? 2 : 4;
    ++part.channels;
  }
  require(part.channels >= 1 && part.channels <= 256, "has no channels, or more than 256");
}

ExrBox exr_box(Reader content) {
  ExrBox box{content.i32(), content.i32(), content.i32(), content.i32()};
  constexpr std::int64_t limit = std::int64_t{1} << 29;
  for (const std::int64_t edge : {box.x_min, box.y_min, box.x_max, box.y_max}) {
    require(edge > -limit && edge < limit, "a window is damaged");
  }
  require_sides(box.width(), box.height());
  return box;
}

/// Whether the attribute matters for the pixels; what Glare must know of it goes to `part`.
bool noted_exr_attribute(const std::string& name, const std::string& type, Reader content,
                         ExrPart& part) {
  static const std::map<std::string, std::string> types = {{"channels", "chlist"},
                                                           {"compression", "compression"},
                                                           {"dataWindow", "box2i"},
                                                           {"displayWindow", "box2i"},
                                                           {"lineOrder", "lineOrder"},
                                                           {"pixelAspectRatio", "float"},
                                                           {"screenWindowCenter", "v2f"},
                                                           {"screenWindowWidth", "float"},
                                                           {"tiles", "tiledesc"},
                                                           {"name", "string"},
                                                           {"type", "string"},
                                                           {"version", "int"},
                                                           {"chunkCount", "int"}};
  const auto known = types.find(name);
  if (known == types.end()) return false;
  require(known->second == type, "an attribute has the wrong type");
  if (name == "channels") require_exr_channels(content, part);
  if (name == "dataWindow") part.data_window = exr_box(content);
  if (name == "displayWindow") part.display_window = exr_box(content);
  if (name == "compression") part.compression = content.u8();
  if (name == "chunkCount") part.chunk_count = content.u32();
  if (name == "tiles") {
    part.tile_width = content.u32();
    part.tile_height = content.u32();
    require_sides(part.tile_width, part.tile_height);
  }
  return true;
}

/// Reads one header up to its end, and writes it back with the attributes that do not matter
/// replaced by one of the same length and no meaning: the file's tables hold positions.
ExrPart cleaned_exr_header(Bytes& bytes, Reader& reader) {
  ExrPart part;
  Bytes kept;
  std::set<std::string> names;
  const std::size_t start = reader.position();
  while (true) {
    const std::size_t attribute_start = reader.position();
    const std::string name = reader.text_z();
    if (name.empty()) break;
    const std::string type = reader.text_z();
    const auto content = reader.take(reader.u32());
    if (!noted_exr_attribute(name, type, Reader(content), part)) continue;
    require(names.insert(name).second, "has an attribute twice");
    append(kept, std::span(bytes).subspan(attribute_start, reader.position() - attribute_start));
  }
  const std::size_t length = reader.position() - 1 - start;
  if (const std::size_t missing = length - kept.size(); missing > 0) {
    require(missing >= 8, "the header is damaged");
    append(kept, std::string_view("-\0-\0", 4));
    append_number(kept, missing - 8, 4, std::endian::little);
    kept.resize(length);
  }
  std::copy(kept.begin(), kept.end(), bytes.begin() + static_cast<std::ptrdiff_t>(start));
  for (const char* name : {"channels", "compression", "dataWindow", "displayWindow"}) {
    require(names.contains(name), "the header is incomplete");
  }
  return part;
}

/// Rows that are compressed together, and how much smaller they can get.
std::pair<uint64_t, uint64_t> exr_rows_and_ratio(unsigned compression) {
  switch (compression) {
    case 0:
      return {1, 1};
    case 1:
      return {1, 64};
    case 2:
      return {1, kDeflateRatio};
    case 3:
      return {16, kDeflateRatio};
    case 4:
      return {32, kDeflateRatio};  // PIZ: Huffman codes for runs of 255.
    case 5:
      return {16, kDeflateRatio * 4 / 3};  // PXR24 drops a byte of a float first.
    case 6:
    case 7:
      return {32, 11};
    case 8:
      return {32, 140000};  // DWA: 64 values may become 2 bytes, deflated.
    case 9:
      return {256, 140000};
    default:
      throw BadImage("is compressed in an unknown way");
  }
}

Header exr_header_of(const ExrPart& part, uint64_t file_bytes) {
  const uint64_t width = part.data_window.width(), height = part.data_window.height();
  const auto [rows, ratio] = exr_rows_and_ratio(part.compression);
  const bool tiled = part.tile_width > 0;
  const uint64_t chunks =
      tiled ? divided_up(width, part.tile_width) * divided_up(height, part.tile_height)
            : divided_up(height, rows);
  Header header{width, height, part.channels};
  header.linear_light = true;
  // Each piece has an entry of 8 bytes in a table, and 8 bytes before its data.
  header.least_bytes = std::max(chunks * 16, width * height * part.pixel_bytes / ratio);
  const uint64_t piece = tiled ? part.tile_width * part.tile_height : width * rows;
  require(header.least_bytes <= file_bytes && part.chunk_count <= file_bytes / 16,
          "the file is cut short");
  header.decoder_bytes = (width * height + 4 * piece) * part.pixel_bytes;
  header.whole_pixels = part.display_window.width() * part.display_window.height();
  return header;
}

}  // namespace

Header checked_exr(Bytes& bytes) {
  Reader reader(bytes);
  reader.skip(4);
  const uint32_t version = reader.u32();
  constexpr uint32_t tiled = 0x200, long_names = 0x400, deep = 0x800, multi_part = 0x1000;
  require((version & 0xFF) == 2, "is of an unknown version of OpenEXR");
  require((version & deep) == 0, "holds deep pixels");
  require((version & ~(0xFFu | tiled | long_names | multi_part)) == 0, "the header is damaged");
  const uint64_t file_bytes = bytes.size();
  const ExrPart part = cleaned_exr_header(bytes, reader);
  // OpenImageIO goes by the attribute and OpenEXR by the bit: where they differ, pixels stay unset.
  require((version & multi_part) != 0 || ((version & tiled) != 0) == (part.tile_width > 0),
          "the header is damaged");
  const Header header = exr_header_of(part, file_bytes);
  while ((version & multi_part) != 0 && byte_at(bytes, reader.position()) != 0) {
    exr_header_of(cleaned_exr_header(bytes, reader), file_bytes);  // For its checks.
  }
  return header;
}

}  // namespace glare::image_io
