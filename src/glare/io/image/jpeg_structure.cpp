// The segments of a JPEG file. Exif blocks and colour profiles are read by decoders whether they
// are wanted or not, and some crash them; a file that is cut short may be taken for a whole one. So
// only the segments that pixels need are kept, and they have to be there up to the marker at the
// end.
#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/structure.h"

namespace glare::image_io {

using std::uint16_t;
using std::uint64_t;
using std::uint8_t;

namespace {

/// Keeps the segments that pixels need, and requires a complete file of the common kinds.
class JpegCleaner {
 public:
  explicit JpegCleaner(const Bytes& bytes) : bytes_(bytes), reader_(bytes, std::endian::big) {
    append(kept_, reader_.take(2));
  }

  Header run() {
    while (!ended_) take_segment();
    require(scans_ > 0, "has no pixels");
    Header header{width_, height_, channels_};
    // Of each block of the scan that is coarsest, at least one bit is stored.
    const uint64_t blocks =
        divided_up(width_, 8 * largest_h_) * divided_up(height_, 8 * largest_v_);
    require(data_bytes_ >= blocks / 8, "has too little data for its size");
    header.least_bytes = blocks / 8;
    header.decoder_bytes = (width_ + 64) * (height_ + 64) * channels_ * 3;
    return header;
  }

  Bytes& kept() { return kept_; }

 private:
  static constexpr int kMaxScans = 200;  // Files of the usual writers have 10 or so.

  uint8_t next_marker() {
    require(reader_.u8() == 0xFF, "the segments are damaged");
    uint8_t marker = 0xFF;
    while (marker == 0xFF) marker = reader_.u8();
    return marker;
  }

  void take_segment() {
    const uint8_t marker = next_marker();
    if (marker == 0xD9) {
      append(kept_, std::string_view("\xFF\xD9"));
      ended_ = true;
      return;
    }
    require(marker >= 0xC0 && !(marker >= 0xD0 && marker <= 0xD8), "the segments are damaged");
    const uint16_t length = reader_.u16();
    require(length >= 2, "the segments are damaged");
    const auto content = reader_.take(length - 2u);
    note(marker, content);
    if (!wanted(marker, text_of(content))) return;
    kept_.push_back(std::byte{0xFF});
    kept_.push_back(std::byte{marker});
    append_number(kept_, length, 2, std::endian::big);
    append(kept_, content);
    if (marker == 0xDA) take_scan();
  }

  static bool wanted(uint8_t marker, std::string_view content) {
    if (marker == 0xE0) return content.starts_with(std::string_view("JFIF\0", 5));
    if (marker == 0xEE) return content.starts_with("Adobe");  // Tells RGB from YCbCr.
    return marker < 0xE0;
  }

  void note(uint8_t marker, std::span<const std::byte> content) {
    switch (marker) {
      case 0xC0:
      case 0xC1:
      case 0xC2:
        return note_frame(content);
      case 0xC4:  // DHT
      case 0xDB:  // DQT
      case 0xDD:
        return;  // DRI
      case 0xDA:
        require(channels_ > 0, "the segments are out of order");
        require(++scans_ <= kMaxScans, "has too many scans");
        return;
      default:
        require(marker >= 0xE0,
                "is of a kind of JPEG that Glare does not read (arithmetic coding, "
                "lossless or hierarchical)");
    }
  }

  void note_frame(std::span<const std::byte> content) {
    Reader frame(content, std::endian::big);
    require(channels_ == 0, "has more than one frame");
    require(frame.u8() == 8, "has more than 8 bits a sample");
    height_ = frame.u16();
    width_ = frame.u16();
    require_sides(width_, height_);
    channels_ = frame.u8();
    require(channels_ != 4, "is CMYK; grey or RGB is expected");
    require(channels_ == 1 || channels_ == 3, "has neither one nor three channels");
    for (uint64_t i = 0; i < channels_; ++i) {
      frame.skip(1);
      const unsigned sampling = frame.u8();
      frame.skip(1);
      require(
          sampling >> 4 >= 1 && sampling >> 4 <= 4 && (sampling & 15) >= 1 && (sampling & 15) <= 4,
          "the frame header is damaged");
      if (channels_ == 1) continue;
      largest_h_ = std::max<uint64_t>(largest_h_, sampling >> 4);
      largest_v_ = std::max<uint64_t>(largest_v_, sampling & 15);
    }
  }

  /// Copies entropy-coded data up to the next marker.
  void take_scan() {
    const std::size_t start = reader_.position();
    std::size_t end = start;
    while (true) {
      const uint8_t byte = byte_at(bytes_, end);
      const uint8_t next = byte == 0xFF ? byte_at(bytes_, end + 1) : 0;
      if (byte == 0xFF && next != 0 && next != 0xFF && !(next >= 0xD0 && next <= 0xD7)) break;
      ++end;
    }
    append(kept_, reader_.take(end - start));
    data_bytes_ += end - start;
  }

  const Bytes& bytes_;
  Reader reader_;
  Bytes kept_;
  uint64_t width_ = 0, height_ = 0, channels_ = 0;
  uint64_t largest_h_ = 1, largest_v_ = 1;
  uint64_t data_bytes_ = 0;
  int scans_ = 0;
  bool ended_ = false;
};

}  // namespace

Header checked_jpeg(Bytes& bytes) {
  JpegCleaner cleaner(bytes);
  const Header header = cleaner.run();
  bytes = std::move(cleaner.kept());
  return header;
}

}  // namespace glare::image_io
