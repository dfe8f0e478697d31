// BMP files without compression. Their header gives sizes, places and a palette's length that need
// not agree with one another or with the file; so what matters is written anew, in the plainest
// way. Compressed ones are refused: OpenImageIO 2.4 decodes run lengths (RLE8) into wrong pixels
// without an error, and refuses the way ImageMagick ends them.
#include <cstdlib>
#include <initializer_list>
#include <span>
#include <utility>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/structure.h"

namespace glare::image_io {

using std::uint32_t;
using std::uint64_t;

namespace {

struct BmpLayout {
  uint64_t width = 0;
  std::int64_t height = 0;  ///< Negative: the first stored row is the top.
  unsigned bits = 0;
  uint64_t most_colors = 0;  ///< Of a palette; 0 if there is none.
  std::span<const std::byte> palette, pixels;

  uint64_t rows() const { return static_cast<uint64_t>(std::abs(height)); }
};

BmpLayout bmp_layout(Reader reader) {
  BmpLayout layout;
  reader.skip(10);
  const uint64_t offset = reader.u32();
  const uint32_t info_bytes = reader.u32();
  require(info_bytes >= 40 && info_bytes <= 124, "is of an old kind of BMP (OS/2)");
  const std::int64_t width = reader.i32();
  layout.height = reader.i32();
  require(width > 0 && layout.height != 0, "the header is damaged");
  layout.width = static_cast<uint64_t>(width);
  require_sides(layout.width, layout.rows());
  reader.skip(2);
  const unsigned bits = layout.bits = reader.u16();
  require(bits == 1 || bits == 4 || bits == 8 || bits == 24 || bits == 32,
          "has a number of bits a pixel that Glare does not read");
  require(reader.u32() == 0, "is compressed; uncompressed BMP is expected");
  reader.skip(12);
  const uint64_t used = reader.u32();
  layout.most_colors = bits <= 8 ? uint64_t{1} << bits : 0;
  require(used <= layout.most_colors || bits > 8, "has a palette of the wrong size");
  const uint64_t colors = bits > 8 ? 0 : used != 0 ? used : layout.most_colors;
  reader.seek(uint64_t{14} + info_bytes);
  layout.palette = reader.take(colors * 4);
  reader.seek(offset);
  layout.pixels = reader.take(divided_up(layout.width * bits, 32) * 4 * layout.rows());
  return layout;
}

Bytes rewritten_bmp(const BmpLayout& layout) {
  Bytes kept;
  const auto append_words = [&](std::initializer_list<uint64_t> words) {
    for (const uint64_t word : words) append_number(kept, word, 4, std::endian::little);
  };
  const uint64_t start = 14 + 40 + layout.most_colors * 4;
  const uint64_t pixel_bytes = layout.pixels.size();
  append(kept, "BM");
  append_words({start + pixel_bytes, 0, start});
  append_words({40, layout.width, static_cast<uint64_t>(layout.height)});
  append_number(kept, 1, 2, std::endian::little);
  append_number(kept, layout.bits, 2, std::endian::little);
  append_words({0, pixel_bytes, 0, 0, layout.most_colors, 0});
  append(kept, layout.palette);
  kept.resize(static_cast<std::size_t>(start));  // Colours that the file leaves out are black.
  append(kept, layout.pixels);
  return kept;
}

}  // namespace

Header checked_bmp(Bytes& bytes) {
  const BmpLayout layout = bmp_layout(Reader(bytes));
  const uint64_t pixel_bytes = layout.pixels.size();
  bytes = rewritten_bmp(layout);
  return {layout.width, layout.rows(), layout.bits == 32 ? 4u : 3u, pixel_bytes, pixel_bytes * 4};
}

}  // namespace glare::image_io
