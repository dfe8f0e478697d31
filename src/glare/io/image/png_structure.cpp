// The chunks of a PNG file. Colour profiles, Exif blocks and texts are read by decoders whether
// they are wanted or not, and some crash them. So only the chunks that pixels need are kept, each
// with a right checksum and in its place.
#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/crc32.h"
#include "glare/io/image/structure.h"

namespace glare::image_io {

using std::uint32_t;
using std::uint64_t;

namespace {

struct PngLayout {
  uint64_t width = 0;
  uint64_t height = 0;
  unsigned bits = 0;
  unsigned color_type = 0;
};

PngLayout png_layout(std::span<const std::byte> ihdr) {
  Reader reader(ihdr, std::endian::big);
  require(ihdr.size() == 13, "the IHDR chunk is damaged");
  PngLayout layout;
  layout.width = reader.u32();
  layout.height = reader.u32();
  layout.bits = reader.u8();
  layout.color_type = reader.u8();
  const unsigned bits = layout.bits;
  const bool small = bits == 1 || bits == 2 || bits == 4;
  const bool grey = layout.color_type == 0 && (small || bits == 8 || bits == 16);
  const bool palette = layout.color_type == 3 && (small || bits == 8);
  const bool other = (layout.color_type == 2 || layout.color_type == 4 || layout.color_type == 6) &&
                     (bits == 8 || bits == 16);
  require(grey || palette || other, "the IHDR chunk names an unknown kind of pixel");
  require(reader.u8() == 0 && reader.u8() == 0 && reader.u8() <= 1, "the IHDR chunk is damaged");
  return layout;
}

/// Samples of a stored pixel, and channels once the palette is looked up (without tRNS).
std::pair<uint64_t, uint64_t> png_samples_and_channels(unsigned color_type) {
  switch (color_type) {
    case 0:
      return {1, 1};
    case 2:
      return {3, 3};
    case 3:
      return {1, 3};
    case 4:
      return {2, 2};
    default:
      return {4, 4};
  }
}

/// Keeps the chunks that pixels need. Their checksums are checked: libpng would print about them.
class PngCleaner {
 public:
  explicit PngCleaner(const Bytes& bytes) : reader_(bytes, std::endian::big) {
    append(kept_, text_of(reader_.take(8)));
  }

  Header run() {
    while (!ended_) take_chunk();
    const auto [samples, channels] = png_samples_and_channels(layout_.color_type);
    const uint64_t row_bytes = 1 + divided_up(layout_.width * samples * layout_.bits, 8);
    Header header{layout_.width, layout_.height, channels + (has_transparency_ ? 1 : 0)};
    header.decoder_bytes =
        layout_.width * layout_.height * header.channels * (layout_.bits / 8 + 1);
    const uint64_t least_data = layout_.height * row_bytes / kDeflateRatio;
    require(data_bytes_ >= least_data, "has too little data for its size");
    header.least_bytes = least_data;
    return header;
  }

  Bytes& kept() { return kept_; }

 private:
  void take_chunk() {
    const std::size_t start = reader_.position();
    const uint32_t length = reader_.u32();
    const auto checked = reader_.take(uint64_t{4} + length);
    const uint32_t checksum = reader_.u32();
    const std::string_view type = text_of(checked).substr(0, 4);
    require(start == 8 ? type == "IHDR" : type != "IHDR", "the IHDR chunk is out of place");
    const bool ancillary = (std::to_integer<unsigned>(checked[0]) & 0x20) != 0;
    if (ancillary && type != "tRNS") return;
    require(crc32(checked) == checksum, "a chunk's checksum is wrong: the file is damaged");
    note(type, checked.subspan(4));
    append_number(kept_, length, 4, std::endian::big);
    append(kept_, checked);
    append_number(kept_, checksum, 4, std::endian::big);
  }

  void note(std::string_view type, std::span<const std::byte> content) {
    if (type == "IHDR") {
      layout_ = png_layout(content);
      require_sides(layout_.width, layout_.height);
    } else if (type == "PLTE") {
      require(palette_size_ == 0 && data_bytes_ == 0, "the PLTE chunk is out of place");
      palette_size_ = content.size() / 3;
      require(content.size() % 3 == 0 && palette_size_ >= 1 && palette_size_ <= 256,
              "the PLTE chunk is damaged");
    } else if (type == "tRNS") {
      note_transparency(content.size());
    } else if (type == "IDAT") {
      require(layout_.color_type != 3 || palette_size_ > 0, "has no palette");
      data_bytes_ += content.size();
    } else {
      require(type == "IEND" && content.empty(), "has an unknown critical chunk");
      require(data_bytes_ > 0, "has no pixels");
      ended_ = true;
    }
  }

  void note_transparency(std::size_t size) {
    const bool fits = (layout_.color_type == 0 && size == 2) ||
                      (layout_.color_type == 2 && size == 6) ||
                      (layout_.color_type == 3 && size >= 1 && size <= palette_size_);
    require(fits && !has_transparency_ && data_bytes_ == 0, "the tRNS chunk is damaged");
    has_transparency_ = true;
  }

  Reader reader_;
  Bytes kept_;
  PngLayout layout_;
  std::size_t palette_size_ = 0;
  uint64_t data_bytes_ = 0;
  bool has_transparency_ = false;
  bool ended_ = false;
};

}  // namespace

Header checked_png(Bytes& bytes) {
  PngCleaner cleaner(bytes);
  const Header header = cleaner.run();
  bytes = std::move(cleaner.kept());
  return header;
}

}  // namespace glare::image_io
