// Radiance HDR files. The decoder believes the size in the header, and looks into all of its lines.
// So the pixels have to be enough for the size, and the header is written anew with what they need.
#include <string>
#include <string_view>
#include <utility>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/structure.h"

namespace glare::image_io {

using std::uint64_t;

namespace {

std::string hdr_line(Reader& reader) {
  std::string line;
  while (true) {
    const char character = static_cast<char>(reader.u8());
    if (character == '\n') return line;
    line += character;
    require(line.size() <= 4096, "the header is damaged");
  }
}

}  // namespace

Header checked_hdr(Bytes& bytes) {
  Reader reader(bytes);
  hdr_line(reader);
  std::string line;
  bool rgbe = true;
  while (!(line = hdr_line(reader)).empty()) {
    if (line.starts_with("FORMAT=")) rgbe = line == "FORMAT=32-bit_rle_rgbe";
  }
  require(rgbe, "is of a kind other than 32-bit_rle_rgbe");
  line = hdr_line(reader);
  const std::size_t x = line.find(" +X ");
  require(line.starts_with("-Y ") && x != std::string::npos && x > 3,
          "has rows in an order other than -Y +X, or its size is damaged");
  const std::string_view text(line);
  const uint64_t height = number_from<uint64_t>(text.substr(3, x - 3));
  const uint64_t width = number_from<uint64_t>(text.substr(x + 4));
  require_sides(width, height);
  const bool may_have_runs = width >= 8 && width <= 32767;
  // A row with runs: 4 bytes, and for each channel 2 bytes for 127 pixels.
  const uint64_t row_bytes = may_have_runs ? 4 + 8 * divided_up(width, 127) : 4 * width;
  require(reader.left() >= row_bytes * height, "the file is cut short");
  Bytes kept;
  append(kept, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                   std::to_string(width) + "\n");
  append(kept, reader.take(reader.left()));
  bytes = std::move(kept);
  Header header{width, height, 3, row_bytes * height, width * 64};
  header.linear_light = true;
  return header;
}

}  // namespace glare::image_io
