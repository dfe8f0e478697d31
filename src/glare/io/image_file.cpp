// The only source file that includes OpenImageIO.
//
// OpenImageIO trusts what a file says: it crashes on some colour profiles and Exif blocks, it
// allocates what a header of 40 bytes asks for, and it returns true for some files that are cut
// short. So a file is not handed to it as it is. It is read to memory; for each format a
// `checked_*` function walks through its structure, requires what Glare needs, and leaves only the
// parts that hold pixels (no profiles, texts, thumbnails, private tags). Sizes are checked next,
// against the limits, the memory and the bytes that are there. Only then does OpenImageIO decode
// the rest.
#include "glare/io/image_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"

namespace glare {

namespace {

using Bytes = std::vector<std::byte>;
using std::uint16_t;
using std::uint32_t;
using std::uint64_t;
using std::uint8_t;

constexpr uint64_t kMaxSide = 65535;
constexpr float kLargestAccepted = 1.0f + 1e-3f;  // Rounding of whoever wrote the file.
constexpr uint64_t kDeflateRatio = 1032;          // 258 bytes from 2 bits.

/// What is wrong with the content of a file. It becomes an `InputError` with the file's name.
struct BadImage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void require(bool condition, const char* message) {
  if (!condition) throw BadImage(message);
}

/// What the file's own header says, and what it takes.
struct Header {
  uint64_t width = 0;  ///< Of the picture that the decoder returns.
  uint64_t height = 0;
  uint64_t channels = 0;
  uint64_t least_bytes = 0;    ///< No file of this kind with that many pixels is smaller.
  uint64_t decoder_bytes = 0;  ///< Memory that the decoder may need for itself.
  bool zero_is_white = false;  ///< The first channel is 1 minus what is stored.
};

// Bytes.

uint8_t byte_at(const Bytes& bytes, std::size_t at) {
  require(at < bytes.size(), "the file is cut short");
  return std::to_integer<uint8_t>(bytes[at]);
}

/// Walks through bytes in either byte order, and throws `BadImage` at the end.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes, std::endian order = std::endian::little)
      : bytes_(bytes), order_(order) {}

  std::size_t position() const { return position_; }
  std::size_t left() const { return bytes_.size() - position_; }
  void seek(uint64_t position) {
    require(position <= bytes_.size(), "the file is cut short");
    position_ = static_cast<std::size_t>(position);
  }
  std::span<const std::byte> take(uint64_t count) {
    require(count <= left(), "the file is cut short");
    const auto taken = bytes_.subspan(position_, static_cast<std::size_t>(count));
    position_ += taken.size();
    return taken;
  }
  void skip(uint64_t count) { take(count); }

  /// A whole number of `size` bytes, 1 to 8.
  uint64_t number(std::size_t size) {
    uint64_t value = 0;
    const auto taken = take(size);
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t at = order_ == std::endian::big ? i : size - 1 - i;
      value = value << 8 | std::to_integer<uint64_t>(taken[at]);
    }
    return value;
  }
  uint8_t u8() { return static_cast<uint8_t>(number(1)); }
  uint16_t u16() { return static_cast<uint16_t>(number(2)); }
  uint32_t u32() { return static_cast<uint32_t>(number(4)); }
  std::int64_t i32() { return static_cast<std::int32_t>(u32()); }

  /// Text up to a zero byte, which is taken too.
  std::string text_z() {
    std::string text;
    while (const uint8_t character = u8()) text += static_cast<char>(character);
    return text;
  }

 private:
  std::span<const std::byte> bytes_;
  std::endian order_;
  std::size_t position_ = 0;
};

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool starts_with(const Bytes& bytes, std::string_view magic) {
  return text_of(bytes).starts_with(magic);
}

void append(Bytes& to, std::span<const std::byte> bytes) {
  to.insert(to.end(), bytes.begin(), bytes.end());
}

void append(Bytes& to, std::string_view text) { append(to, std::as_bytes(std::span(text))); }

void append_number(Bytes& to, uint64_t value, std::size_t size, std::endian order) {
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t at = order == std::endian::little ? i : size - 1 - i;
    to.push_back(static_cast<std::byte>(value >> (8 * at)));
  }
}

uint64_t divided_up(uint64_t value, uint64_t by) { return value / by + (value % by != 0); }

void require_sides(uint64_t width, uint64_t height) {
  require(width > 0 && height > 0, "the picture has no pixels");
  if (width <= kMaxSide && height <= kMaxSide) return;
  throw BadImage("says it is " + std::to_string(width) + " x " + std::to_string(height) +
                 " pixels; each side can be 65535 at most");
}

// PNG.

std::array<uint32_t, 256> crc_table() {
  std::array<uint32_t, 256> table{};
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ (value & 1 ? 0xEDB88320u : 0u);
    table[i] = value;
  }
  return table;
}

uint32_t crc32(std::span<const std::byte> bytes) {
  static const std::array<uint32_t, 256> table = crc_table();
  uint32_t crc = 0xFFFFFFFFu;
  for (const std::byte b : bytes) {
    crc = table[(crc ^ std::to_integer<uint32_t>(b)) & 0xFF] ^ (crc >> 8);
  }
  return ~crc;
}

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

Header checked_png(Bytes& bytes) {
  PngCleaner cleaner(bytes);
  const Header header = cleaner.run();
  bytes = std::move(cleaner.kept());
  return header;
}

// JPEG.

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

Header checked_jpeg(Bytes& bytes) {
  JpegCleaner cleaner(bytes);
  const Header header = cleaner.run();
  bytes = std::move(cleaner.kept());
  return header;
}

// TIFF.

enum TiffTag : uint16_t {
  kImageWidth = 256,
  kImageLength = 257,
  kBitsPerSample = 258,
  kCompression = 259,
  kPhotometric = 262,
  kFillOrder = 266,
  kStripOffsets = 273,
  kSamplesPerPixel = 277,
  kRowsPerStrip = 278,
  kStripByteCounts = 279,
  kPlanarConfig = 284,
  kPredictor = 317,
  kColorMap = 320,
  kTileWidth = 322,
  kTileLength = 323,
  kTileOffsets = 324,
  kTileByteCounts = 325,
  kExtraSamples = 338,
  kSampleFormat = 339,
};
constexpr std::array<uint16_t, 19> kTiffTags = {
    kImageWidth,   kImageLength,    kBitsPerSample,   kCompression,  kPhotometric,
    kFillOrder,    kStripOffsets,   kSamplesPerPixel, kRowsPerStrip, kStripByteCounts,
    kPlanarConfig, kPredictor,      kColorMap,        kTileWidth,    kTileLength,
    kTileOffsets,  kTileByteCounts, kExtraSamples,    kSampleFormat};

constexpr uint64_t kMaxTiffCount = uint64_t{1} << 22;  // Strips or tiles of a picture.

/// The first directory of a TIFF file, classic or big, reduced to the tags that pixels need.
class TiffDirectory {
 public:
  explicit TiffDirectory(const Bytes& bytes)
      : bytes_(bytes), order_(starts_with(bytes, "MM") ? std::endian::big : std::endian::little) {
    Reader reader(bytes, order_);
    reader.skip(2);
    big_ = reader.u16() == 43;
    if (big_) require(reader.u16() == 8 && reader.u16() == 0, "the header is damaged");
    reader.seek(reader.number(word()));
    const uint64_t count = reader.number(big_ ? 8 : 2);
    require(count <= 4096, "the directory is damaged");
    for (uint64_t i = 0; i < count; ++i) take_entry(reader);
    if (!has(kBitsPerSample)) replace(kBitsPerSample, 1);  // OpenImageIO would take it for 8.
  }

  bool has(uint16_t tag) const { return entries_.contains(tag); }

  /// The numbers of a tag; `otherwise` alone if the tag is missing.
  std::vector<uint64_t> numbers(uint16_t tag, uint64_t otherwise) const {
    const auto found = entries_.find(tag);
    return found == entries_.end() ? std::vector<uint64_t>{otherwise} : found->second.numbers;
  }
  uint64_t number(uint16_t tag, uint64_t otherwise) const {
    return numbers(tag, otherwise).front();
  }

  /// Gives a tag this number alone.
  void replace(uint16_t tag, uint64_t value) {
    Entry entry{{}, {value}, 0};
    append_number(entry.stored, tag, 2, order_);
    append_number(entry.stored, 3, 2, order_);
    append_number(entry.stored, 1, word(), order_);
    append_number(entry.stored, value, 2, order_);
    entry.stored.resize(4 + 2 * word());
    entries_.insert_or_assign(tag, std::move(entry));
  }

  /// Makes the colours of a palette multiples of 257: OpenImageIO rounds down what lies between,
  /// and some writers use multiples of 256.
  void round_palette(Bytes& bytes) const {
    const auto found = entries_.find(kColorMap);
    if (found == entries_.end() || found->second.position == 0) return;
    Bytes rounded;
    for (const uint64_t color : found->second.numbers) {
      append_number(rounded, (color >> 8) * 257, 2, order_);
    }
    std::copy(rounded.begin(), rounded.end(),
              bytes.begin() + static_cast<std::ptrdiff_t>(found->second.position));
  }

  /// Adds to `bytes`, the file, a directory of only these tags, and makes it the file's only one.
  void append_to(Bytes& bytes) const {
    if (bytes.size() % 2 != 0) bytes.push_back(std::byte{0});
    const uint64_t position = bytes.size();
    require(big_ || position <= std::numeric_limits<uint32_t>::max(), "is too large for a TIFF");
    append_number(bytes, entries_.size(), big_ ? 8 : 2, order_);
    for (const auto& [tag, entry] : entries_) append(bytes, entry.stored);
    append_number(bytes, 0, word(), order_);
    Bytes start;
    append_number(start, position, word(), order_);
    std::copy(start.begin(), start.end(), bytes.begin() + (big_ ? 8 : 4));
  }

 private:
  struct Entry {
    Bytes stored;
    std::vector<uint64_t> numbers;
    std::size_t position = 0;  ///< Of the numbers, in the file; 0 if they are in the entry.
  };

  std::size_t word() const { return big_ ? 8 : 4; }

  void take_entry(Reader& reader) {
    const auto stored = reader.take(4 + 2 * word());
    Reader entry(stored, order_);
    const uint16_t tag = entry.u16();
    if (std::find(kTiffTags.begin(), kTiffTags.end(), tag) == kTiffTags.end()) return;
    const uint16_t type = entry.u16();
    const std::size_t size = type == 1 ? 1 : type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
    require(size != 0 && (size != 8 || big_), "a tag has the wrong type");
    const uint64_t count = entry.number(word());
    require(count >= 1 && count <= kMaxTiffCount, "a tag is damaged");
    require(tag != kColorMap || type == 3, "a tag has the wrong type");
    require(!has(tag), "has a tag twice");
    Entry kept{Bytes(stored.begin(), stored.end()), {}, 0};
    Reader values = entry;
    if (count * size > word()) {
      values = Reader(bytes_, order_);
      values.seek(entry.number(word()));
      kept.position = values.position();
    }
    for (uint64_t i = 0; i < count; ++i) kept.numbers.push_back(values.number(size));
    entries_.emplace(tag, std::move(kept));
  }

  const Bytes& bytes_;
  std::endian order_;
  bool big_ = false;
  std::map<uint16_t, Entry> entries_;
};

/// The value that all samples share.
uint64_t common_number(const TiffDirectory& directory, TiffTag tag, uint64_t otherwise) {
  const std::vector<uint64_t> values = directory.numbers(tag, otherwise);
  require(std::all_of(values.begin(), values.end(), [&](uint64_t v) { return v == values[0]; }),
          "has channels of different kinds");
  return values[0];
}

uint64_t tiff_ratio(uint64_t compression) {
  switch (compression) {
    case 1:
      return 1;
    case 5:
      return 2600;  // LZW: 3838 bytes from 12 bits.
    case 8:
    case 32946:
      return kDeflateRatio;
    case 32773:
      return 64;  // PackBits.
    default:
      throw BadImage("is compressed with TIFF scheme " + std::to_string(compression) +
                     "; none, LZW, Deflate and PackBits are read");
  }
}

/// Bits of a sample, after checking that it is of a kind that is read.
uint64_t tiff_sample_bits(const TiffDirectory& directory) {
  const uint64_t bits = common_number(directory, kBitsPerSample, 1);
  const uint64_t format = common_number(directory, kSampleFormat, 1);
  const bool whole =
      format == 1 && (bits == 1 || bits == 2 || bits == 4 || bits == 8 || bits == 16 || bits == 32);
  const bool real = format == 3 && (bits == 16 || bits == 32 || bits == 64);
  require(whole || real, "has samples that are neither unsigned whole numbers nor floats");
  return bits;
}

/// Channels that the decoder returns, after checking that the colours are of a kind that is read.
uint64_t tiff_channels(const TiffDirectory& directory, uint64_t samples, uint64_t bits) {
  switch (directory.number(kPhotometric, 1)) {
    case 0:
    case 1:
      require(samples <= 2, "is grey with more than one extra channel");
      return samples;
    case 2:
      require(samples == 3 || samples == 4, "is RGB with too few or too many channels");
      return samples;
    case 3:
      require(samples == 1 && bits <= 8, "has a palette that does not fit its samples");
      require(directory.numbers(kColorMap, 0).size() == (std::size_t{3} << bits),
              "has a palette of the wrong size");
      return 3;
    default:
      throw BadImage("is neither grey nor RGB (CMYK, YCbCr, Lab or other)");
  }
}

/// The strips or tiles: their pixels, how many there are, and where they lie.
struct TiffPieces {
  uint64_t width, height, count;
  TiffTag offsets, byte_counts;
};

TiffPieces tiff_pieces(const TiffDirectory& directory, uint64_t width, uint64_t height) {
  if (!directory.has(kTileWidth)) {
    const uint64_t rows = std::min(directory.number(kRowsPerStrip, height), height);
    require(rows > 0, "a tag is damaged");
    return {width, rows, divided_up(height, rows), kStripOffsets, kStripByteCounts};
  }
  const uint64_t tile_width = directory.number(kTileWidth, 0);
  const uint64_t tile_height = directory.number(kTileLength, 0);
  require(tile_width % 16 == 0 && tile_height % 16 == 0, "has tiles of an odd size");
  require_sides(tile_width, tile_height);
  const uint64_t count = divided_up(width, tile_width) * divided_up(height, tile_height);
  return {tile_width, tile_height, count, kTileOffsets, kTileByteCounts};
}

/// The bytes of all pieces, after checking that every piece lies inside the file.
uint64_t tiff_data_bytes(const TiffDirectory& directory, const TiffPieces& pieces, uint64_t count,
                         uint64_t file_bytes) {
  require(directory.has(pieces.offsets) && directory.has(pieces.byte_counts), "has no pixels");
  const std::vector<uint64_t> offsets = directory.numbers(pieces.offsets, 0);
  const std::vector<uint64_t> sizes = directory.numbers(pieces.byte_counts, 0);
  require(offsets.size() == count && sizes.size() == count, "the tables of strips are damaged");
  uint64_t total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    require(sizes[i] <= file_bytes && offsets[i] <= file_bytes - sizes[i], "the file is cut short");
    total += sizes[i];
  }
  require(total <= file_bytes, "has strips that overlap");
  return total;
}

Header checked_tiff(Bytes& bytes) {
  TiffDirectory directory(bytes);
  const uint64_t width = directory.number(kImageWidth, 0);
  const uint64_t height = directory.number(kImageLength, 0);
  require_sides(width, height);
  const uint64_t samples = directory.number(kSamplesPerPixel, 1);
  require(samples >= 1 && samples <= 4, "has more than 4 channels");
  const uint64_t bits = tiff_sample_bits(directory);
  const uint64_t planar = directory.number(kPlanarConfig, 1);
  require(planar == 1 || planar == 2, "a tag is damaged");
  const TiffPieces pieces = tiff_pieces(directory, width, height);
  const uint64_t count = pieces.count * (planar == 2 ? samples : 1);
  const uint64_t data_bytes = tiff_data_bytes(directory, pieces, count, bytes.size());
  const uint64_t piece_row_bytes = divided_up(pieces.width * bits * (planar == 2 ? 1 : samples), 8);
  const uint64_t piece_bytes = piece_row_bytes * pieces.height;
  const uint64_t ratio = tiff_ratio(directory.number(kCompression, 1));
  // The last strip may have fewer rows.
  const uint64_t row_bytes = divided_up(width * bits * (planar == 2 ? 1 : samples), 8);
  const uint64_t raw_bytes = row_bytes * height * (planar == 2 ? samples : 1);
  require(data_bytes >= raw_bytes / ratio, "has too little data for its size");
  Header header{width, height, tiff_channels(directory, samples, bits), raw_bytes / ratio, 0};
  header.decoder_bytes = 2 * raw_bytes + 4 * piece_bytes * samples;
  if (directory.number(kPhotometric, 1) == 3) directory.round_palette(bytes);
  if (directory.number(kPhotometric, 1) == 0) {
    // OpenImageIO turns some kinds of samples and leaves others.
    header.zero_is_white = true;
    directory.replace(kPhotometric, 1);
  }
  directory.append_to(bytes);
  return header;
}

// OpenEXR.

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
    require(type != 0, "has a channel of whole numbers (identities, not transmittances)");
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
  // Each piece has an entry of 8 bytes in a table, and 8 bytes before its data.
  header.least_bytes = std::max(chunks * 16, width * height * part.pixel_bytes / ratio);
  const uint64_t piece = tiled ? part.tile_width * part.tile_height : width * rows;
  require(header.least_bytes <= file_bytes && part.chunk_count <= file_bytes / 16,
          "the file is cut short");
  header.decoder_bytes = (width * height + 4 * piece) * part.pixel_bytes +
                         part.display_window.width() * part.display_window.height() * 4;
  return header;
}

Header checked_exr(Bytes& bytes) {
  Reader reader(bytes);
  reader.skip(4);
  const uint32_t version = reader.u32();
  constexpr uint32_t tiled = 0x200, long_names = 0x400, deep = 0x800, multi_part = 0x1000;
  require((version & 0xFF) == 2, "is of an unknown version of OpenEXR");
  require((version & deep) == 0, "holds deep pixels");
  require((version & ~(0xFFu | tiled | long_names | multi_part)) == 0, "the header is damaged");
  const uint64_t file_bytes = bytes.size();
  const Header header = exr_header_of(cleaned_exr_header(bytes, reader), file_bytes);
  while ((version & multi_part) != 0 && byte_at(bytes, reader.position()) != 0) {
    exr_header_of(cleaned_exr_header(bytes, reader), file_bytes);  // For its checks.
  }
  return header;
}

// PNM.

/// The next word of a PNM header: comments and white space before it are skipped.
std::string pnm_word(Reader& reader) {
  std::string word;
  while (true) {
    char character = static_cast<char>(reader.u8());
    if (character == '#' && word.empty()) {
      while (character != '\n' && character != '\r') character = static_cast<char>(reader.u8());
    } else if (!std::isspace(static_cast<unsigned char>(character))) {
      word += character;
      require(word.size() <= 32, "the header is damaged");
    } else if (!word.empty()) {
      return word;
    }
  }
}

template <typename T>
T number_from(std::string_view word) {
  T number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  require(error == std::errc{} && end == word.data() + word.size(), "the header is damaged");
  return number;
}

std::string sign_of_pfm_scale(const std::string& word) {
  const float scale = number_from<float>(word);
  require(std::isfinite(scale) && scale != 0, "the header is damaged");
  return scale < 0 ? "-1.0" : "1.0";  // Only its sign, the byte order: values are used as stored.
}

/// The digits of a plain PBM, which may stand without spaces between them.
std::string spaced_bits(std::string_view text, uint64_t count) {
  std::string bits;
  for (const char character : text) {
    if (bits.size() == 2 * count) break;
    if (std::isspace(static_cast<unsigned char>(character))) continue;
    require(character == '0' || character == '1', "has something else than 0 and 1");
    bits += character;
    bits += '\n';
  }
  require(bits.size() == 2 * count, "the file is cut short");
  return bits;
}

uint64_t least_pnm_bytes(char kind, uint64_t width, uint64_t height, uint64_t channels,
                         unsigned maximum) {
  const uint64_t samples = width * height * channels;
  switch (kind) {
    case '1':
      return samples;
    case '2':
    case '3':
      return 2 * samples - 1;
    case '4':
      return divided_up(width, 8) * height;
    case 'F':
    case 'f':
      return samples * 4;
    default:
      return samples * (maximum > 255 ? 2 : 1);
  }
}

/// The samples of a PGM or PPM as a share of the maximum.
std::vector<float> pnm_samples(Reader reader, bool plain, uint64_t count, unsigned maximum) {
  Bytes text;
  if (plain) append(text, reader.take(reader.left()));
  if (plain) append(text, "\n");  // A plain number may be the file's last byte.
  Reader words(text);
  std::vector<float> samples;
  samples.reserve(count);
  for (uint64_t i = 0; i < count; ++i) {
    const uint64_t value =
        plain ? number_from<uint64_t>(pnm_word(words)) : reader.number(maximum > 255 ? 2 : 1);
    require(value <= maximum, "has a value above its maximum");
    samples.push_back(static_cast<float>(static_cast<double>(value) / maximum));
  }
  return samples;
}

/// The samples as the pixels of a PFM file of scale -1: from the last row to the first.
Bytes pfm_pixels(std::span<const float> samples, std::size_t row_samples) {
  Bytes pixels;
  pixels.reserve(4 * samples.size());
  for (std::size_t end = samples.size(); end > 0; end -= row_samples) {
    for (const float sample : samples.subspan(end - row_samples, row_samples)) {
      append_number(pixels, std::bit_cast<uint32_t>(sample), 4, std::endian::little);
    }
  }
  return pixels;
}

/// The header of a PNM file. `fields` is what stands after the sizes: a maximum, or a scale.
std::string pnm_start(char kind, const Header& header, const std::string& fields) {
  return std::string("P") + kind + "\n" + std::to_string(header.width) + " " +
         std::to_string(header.height) + "\n" + (fields.empty() ? "" : fields + "\n");
}

/// The file anew: a header without comments, and pixels of a kind that is decoded well. Of 16-bit
/// ones OpenImageIO 2.4 makes 65534 out of 65535, and of other maxima than 255 it keeps 8 bits.
Bytes rewritten_pnm(Reader& reader, char kind, const Header& header, const std::string& scale,
                    unsigned maximum) {
  Bytes kept;
  const uint64_t row_samples = header.width * header.channels;
  const bool plain = kind == '2' || kind == '3';
  const bool whole = kind == '5' || kind == '6';
  if (kind == '1') {
    append(kept, pnm_start(kind, header, ""));
    append(kept, spaced_bits(text_of(reader.take(reader.left())), row_samples * header.height));
  } else if (plain || (whole && maximum != 255)) {
    const Reader pixels(reader.take(reader.left()), std::endian::big);
    append(kept, pnm_start(header.channels == 3 ? 'F' : 'f', header, "-1.0"));
    append(kept, pfm_pixels(pnm_samples(pixels, plain, row_samples * header.height, maximum),
                            row_samples));
  } else {
    append(kept, pnm_start(kind, header, whole ? "255" : scale));
    append(kept, reader.take(header.least_bytes));
  }
  return kept;
}

Header checked_pnm(Bytes& bytes) {
  Reader reader(bytes);
  reader.skip(1);
  const char kind = static_cast<char>(reader.u8());
  const uint64_t width = number_from<uint64_t>(pnm_word(reader));
  const uint64_t height = number_from<uint64_t>(pnm_word(reader));
  require_sides(width, height);
  const bool real = kind == 'f' || kind == 'F';
  const bool bits = kind == '1' || kind == '4';
  const std::string scale = real ? sign_of_pfm_scale(pnm_word(reader)) : "";
  const unsigned maximum = real || bits ? 1 : number_from<unsigned>(pnm_word(reader));
  require(maximum >= 1 && maximum <= 65535, "has a maximum outside 1 to 65535");
  Header header{width, height, kind == '3' || kind == '6' || kind == 'F' ? 3u : 1u};
  header.least_bytes = least_pnm_bytes(kind, width, height, header.channels, maximum);
  header.decoder_bytes = width * height * header.channels * 12;
  require(reader.left() >= header.least_bytes, "the file is cut short");
  bytes = rewritten_pnm(reader, kind, header, scale, maximum);
  return header;
}

// BMP.

Header checked_bmp(Bytes& bytes) {
  Reader reader(bytes);
  reader.skip(10);
  const uint64_t offset = reader.u32();
  const uint32_t info_bytes = reader.u32();
  require(info_bytes >= 40 && info_bytes <= 124, "is of an old kind of BMP (OS/2)");
  const std::int64_t width = reader.i32(), height = reader.i32();
  require(width > 0 && height != 0, "the header is damaged");
  const auto rows = static_cast<uint64_t>(std::abs(height));
  require_sides(static_cast<uint64_t>(width), rows);
  reader.skip(2);
  const unsigned bits = reader.u16();
  require(bits == 1 || bits == 4 || bits == 8 || bits == 24 || bits == 32,
          "has a number of bits a pixel that Glare does not read");
  require(reader.u32() == 0, "is compressed; uncompressed BMP is expected");
  reader.skip(12);
  const uint64_t used = reader.u32();
  const uint64_t most_colors = bits <= 8 ? uint64_t{1} << bits : 0;
  require(used <= most_colors || bits > 8, "has a palette of the wrong size");
  const uint64_t colors = bits > 8 ? 0 : used != 0 ? used : most_colors;
  reader.seek(uint64_t{14} + info_bytes);
  const auto palette = reader.take(colors * 4);
  reader.seek(offset);
  const uint64_t pixel_bytes = divided_up(static_cast<uint64_t>(width) * bits, 32) * 4 * rows;
  const auto pixels = reader.take(pixel_bytes);
  Bytes kept;
  const uint64_t start = 14 + 40 + most_colors * 4;
  append(kept, "BM");
  for (const uint64_t value : {start + pixel_bytes, uint64_t{0}, start, uint64_t{40}}) {
    append_number(kept, value, 4, std::endian::little);
  }
  append_number(kept, static_cast<uint64_t>(width), 4, std::endian::little);
  append_number(kept, static_cast<uint64_t>(height), 4, std::endian::little);
  append_number(kept, 1, 2, std::endian::little);
  append_number(kept, bits, 2, std::endian::little);
  for (const uint64_t value :
       {uint64_t{0}, pixel_bytes, uint64_t{0}, uint64_t{0}, most_colors, uint64_t{0}}) {
    append_number(kept, value, 4, std::endian::little);
  }
  append(kept, palette);
  kept.resize(static_cast<std::size_t>(start));  // Colours that the file leaves out are black.
  append(kept, pixels);
  bytes = std::move(kept);
  return {static_cast<uint64_t>(width), rows, bits == 32 ? 4u : 3u, pixel_bytes, pixel_bytes * 4};
}

// Radiance HDR.

std::string hdr_line(Reader& reader) {
  std::string line;
  while (true) {
    const char character = static_cast<char>(reader.u8());
    if (character == '\n') return line;
    line += character;
    require(line.size() <= 4096, "the header is damaged");
  }
}

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
  return {width, height, 3, row_bytes * height, width * 64};
}

// Which format.

struct Format {
  const char* name;    ///< For people.
  const char* reader;  ///< OpenImageIO's name.
  Header (*checked)(Bytes&);
};

constexpr Format kPng{"PNG", "png", checked_png};
constexpr Format kJpeg{"JPEG", "jpeg", checked_jpeg};
constexpr Format kTiff{"TIFF", "tiff", checked_tiff};
constexpr Format kExr{"OpenEXR", "openexr", checked_exr};
constexpr Format kPnm{"PNM", "pnm", checked_pnm};
constexpr Format kBmp{"BMP", "bmp", checked_bmp};
constexpr Format kHdr{"Radiance HDR", "hdr", checked_hdr};

bool is_pnm(const Bytes& bytes) {
  if (bytes.size() < 3 || !starts_with(bytes, "P")) return false;
  const std::string_view text = text_of(bytes);
  return std::string_view("123456Ff").find(text[1]) != std::string_view::npos &&
         (std::isspace(static_cast<unsigned char>(text[2])) || text[2] == '#');
}

const Format* format_of(const Bytes& bytes) {
  using std::string_view_literals::operator""sv;
  const std::pair<std::string_view, const Format*> magics[] = {{"\x89PNG\r\n\x1a\n"sv, &kPng},
                                                               {"\xFF\xD8\xFF"sv, &kJpeg},
                                                               {"II*\0"sv, &kTiff},
                                                               {"MM\0*"sv, &kTiff},
                                                               {"II+\0"sv, &kTiff},
                                                               {"MM\0+"sv, &kTiff},
                                                               {"v/1\x01"sv, &kExr},
                                                               {"BM"sv, &kBmp},
                                                               {"#?RADIANCE\n"sv, &kHdr},
                                                               {"#?RGBE\n"sv, &kHdr}};
  for (const auto& [magic, format] : magics) {
    if (starts_with(bytes, magic)) return format;
  }
  return is_pnm(bytes) ? &kPnm : nullptr;
}

bool is_text(const Bytes& bytes) {
  const std::string_view start = text_of(bytes).substr(0, 1024);
  return std::all_of(start.begin(), start.end(), [](unsigned char character) {
    return character >= 32 ? character != 127 : std::isspace(character) != 0;
  });
}

/// What a file is that is none of the formats, for the message; the start of a sentence.
std::string other_kind_of(const Bytes& bytes) {
  using std::string_view_literals::operator""sv;
  if (bytes.empty()) return "the file is empty";
  constexpr std::pair<std::string_view, const char*> magics[] = {
      {"GIF8"sv, "is a GIF"},
      {"%PDF"sv, "is a PDF"},
      {"8BPS"sv, "is a Photoshop file"},
      {"PK\x03\x04"sv, "is a ZIP archive"},
      {"\x1F\x8B"sv, "is gzip-compressed"},
      {"DDS "sv, "is a DDS texture"},
      {"P7\n"sv, "is a PAM picture"},
      {"SDPX"sv, "is a DPX picture"},
      {"XPDS"sv, "is a DPX picture"},
      {"SIMPLE  ="sv, "is a FITS file"},
      {"\0\0\0\x0CjP  "sv, "is a JPEG 2000 picture"},
      {"\xFF\x0A"sv, "is a JPEG XL picture"},
      {"\0\0\0\x0CJXL "sv, "is a JPEG XL picture"},
      {"\x7F"
       "ELF"sv,
       "is a program"}};
  for (const auto& [magic, kind] : magics) {
    if (starts_with(bytes, magic)) return kind;
  }
  const std::string_view text = text_of(bytes);
  if (text.starts_with("RIFF") && text.substr(0, 12).ends_with("WEBP")) return "is a WebP picture";
  if (text.substr(0, 12).find("ftyp") == 4) return "is a HEIF or AVIF picture or a video";
  const std::string_view first = text.substr(0, 512);
  if (first.find("<svg") != std::string_view::npos) return "is an SVG drawing";
  return is_text(bytes) ? "is a text" : "is of an unknown kind";
}

const Format& recognized_format(const Bytes& bytes) {
  if (const Format* format = format_of(bytes)) return *format;
  throw BadImage(other_kind_of(bytes) +
                 ", not an image that Glare reads (PNG, JPEG, TIFF, OpenEXR, PNM, BMP, HDR)");
}

// Decoding.

/// The pixels as the decoder gives them: a data window, perhaps of a larger picture.
struct Pixels {
  int width = 0, height = 0;            ///< Of what is stored.
  int x = 0, y = 0;                     ///< Its place in the whole picture.
  int full_width = 0, full_height = 0;  ///< The whole picture.
  int channels = 0;
  std::vector<std::string> names;
  std::vector<float> values;

  float operator()(int column, int row, int channel) const {
    const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column);
    return values[pixel * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel)];
  }
};

uint64_t required_bytes(const Header& header, uint64_t file_bytes) {
  const uint64_t pixels = header.width * header.height;
  return 2 * file_bytes + header.decoder_bytes + pixels * 4 * (header.channels + 1);
}

void require_fits(const Header& header, uint64_t file_bytes, uint64_t max_bytes) {
  require_sides(header.width, header.height);
  require(header.channels > 0, "has no channels");
  require(file_bytes >= header.least_bytes, "has too little data for its size");
  const uint64_t needed = required_bytes(header, file_bytes);
  if (needed > max_bytes) throw MemoryError(needed, max_bytes);
}

/// The decoder's message as one line.
std::string one_line(std::string message) {
  while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back()))) {
    message.pop_back();
  }
  for (char& character : message) {
    if (std::iscntrl(static_cast<unsigned char>(character))) character = ' ';
  }
  return message.empty() ? "the data are damaged or cut short" : message;
}

void require_as_declared(const OIIO::ImageSpec& spec, const Header& header) {
  const bool same = spec.width > 0 && spec.height > 0 && spec.nchannels > 0 && spec.depth <= 1 &&
                    static_cast<uint64_t>(spec.width) == header.width &&
                    static_cast<uint64_t>(spec.height) == header.height &&
                    static_cast<uint64_t>(spec.nchannels) <= header.channels && !spec.deep;
  require(same, "the header is damaged");
}

Pixels pixels_for(const OIIO::ImageSpec& spec) {
  Pixels pixels;
  pixels.width = spec.width;
  pixels.height = spec.height;
  pixels.x = spec.x - spec.full_x;
  pixels.y = spec.y - spec.full_y;
  pixels.full_width = spec.full_width > 0 ? spec.full_width : spec.width;
  pixels.full_height = spec.full_height > 0 ? spec.full_height : spec.height;
  pixels.channels = spec.nchannels;
  pixels.names = spec.channelnames;
  const auto count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                     static_cast<std::size_t>(spec.nchannels);
  pixels.values.resize(count);
  return pixels;
}

void turn_first_channel(Pixels& pixels) {
  const auto step = static_cast<std::size_t>(pixels.channels);
  for (std::size_t i = 0; i < pixels.values.size(); i += step) {
    pixels.values[i] = 1 - pixels.values[i];
  }
}

Pixels decoded(const Format& format, const Header& header, Bytes& bytes) {
  const auto input = OIIO::ImageInput::create(format.reader);
  if (!input) throw BadImage("OpenImageIO has no reader for it: " + one_line(OIIO::geterror()));
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  input->set_ioproxy(&memory);
  input->threads(1);
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageSpec spec;
  if (!input->open(std::string("the file.") + format.reader, spec, as_stored)) {
    throw BadImage(one_line(input->geterror()));
  }
  require_as_declared(spec, header);
  Pixels pixels = pixels_for(spec);
  const bool read =
      input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.values.data());
  // A file that is cut short may give true, and only a message.
  const std::string message = input->geterror();
  input->close();
  if (!read || !message.empty()) throw BadImage(one_line(message));
  if (header.zero_is_white) turn_first_channel(pixels);
  return pixels;
}

// From channels to transmittance.

/// Which channels are what; -1: there is none.
struct Roles {
  std::array<int, 3> color = {-1, -1, -1};  ///< The second and third are -1 for a grey picture.
  int alpha = -1;
  bool others = false;  ///< There are further channels.

  bool grey() const { return color[1] < 0; }
};

Roles roles_by_position(int channels) {
  switch (channels) {
    case 1:
      return {{0, -1, -1}, -1, false};
    case 2:
      return {{0, -1, -1}, 1, false};
    case 3:
      return {{0, 1, 2}, -1, false};
    case 4:
      return {{0, 1, 2}, 3, false};
    default:
      throw BadImage("has " + std::to_string(channels) + " channels; 1 to 4 are expected");
  }
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

Roles roles_by_name(const std::vector<std::string>& names) {
  const auto find = [&](std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
  };
  Roles roles;
  roles.alpha = find("A");
  const std::size_t known_alpha = roles.alpha >= 0 ? 1 : 0;
  if (find("R") >= 0 && find("G") >= 0 && find("B") >= 0) {
    roles.color = {find("R"), find("G"), find("B")};
    roles.others = names.size() > 3 + known_alpha;
  } else if (find("Y") >= 0) {
    roles.color[0] = find("Y");
    roles.others = names.size() > 1 + known_alpha;
  } else if (names.size() == 1) {
    return {{0, -1, -1}, -1, false};
  } else if (names.size() == 2 && roles.alpha >= 0) {
    roles.color[0] = 1 - roles.alpha;
  } else {
    throw BadImage("has channels " + one_line(joined(names)) +
                   "; R, G and B, or Y, or a single one is expected");
  }
  return roles;
}

bool is_constant(const Pixels& pixels, int channel) {
  const auto step = static_cast<std::size_t>(pixels.channels);
  const auto offset = static_cast<std::size_t>(channel);
  for (std::size_t i = offset; i < pixels.values.size(); i += step) {
    if (pixels.values[i] != pixels.values[offset]) return false;
  }
  return true;
}

bool only_alpha_varies(const Pixels& pixels, const Roles& roles) {
  if (roles.alpha < 0 || is_constant(pixels, roles.alpha)) return false;
  return std::all_of(roles.color.begin(), roles.color.end(),
                     [&](int channel) { return channel < 0 || is_constant(pixels, channel); });
}

float checked_value(float value, int x, int y) {
  if (value >= 0 && value <= kLargestAccepted) return std::min(value, 1.0f);
  char number[32];
  std::snprintf(number, sizeof number, "%.6g", static_cast<double>(value));
  throw BadImage("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " + number +
                 "; a transmittance from 0 to 1 is expected");
}

float luminance(float red, float green, float blue) {
  if (red == green && green == blue) return red;
  return static_cast<float>(0.2126 * red + 0.7152 * green + 0.0722 * blue);
}

Image<float> transmittance_of(const Pixels& pixels, const Roles& roles) {
  Image<float> image(pixels.full_width, pixels.full_height);
  const auto value_at = [&](int column, int row, int channel) {
    return checked_value(pixels(column, row, channel), pixels.x + column, pixels.y + row);
  };
  const int last_row = std::min(pixels.height, pixels.full_height - pixels.y);
  const int last_column = std::min(pixels.width, pixels.full_width - pixels.x);
  for (int row = std::max(0, -pixels.y); row < last_row; ++row) {
    for (int column = std::max(0, -pixels.x); column < last_column; ++column) {
      const float first = value_at(column, row, roles.color[0]);
      image(pixels.x + column, pixels.y + row) =
          roles.grey() ? first
                       : std::min(1.0f, luminance(first, value_at(column, row, roles.color[1]),
                                                  value_at(column, row, roles.color[2])));
    }
  }
  return image;
}

TransmittanceImage interpreted(const Pixels& pixels, Roles roles) {
  TransmittanceImage result;
  if (only_alpha_varies(pixels, roles)) {
    roles.color = {roles.alpha, -1, -1};
  } else if (roles.alpha >= 0) {
    result.warnings.push_back("the alpha channel is ignored");
  }
  if (roles.others) {
    result.warnings.push_back("only some of the channels " + one_line(joined(pixels.names)) +
                              " are used");
  }
  result.transmittance = transmittance_of(pixels, roles);
  return result;
}

Bytes read_limited(const std::filesystem::path& path, uint64_t max_bytes) {
  std::error_code error;
  const bool regular = std::filesystem::is_regular_file(path, error);
  const uint64_t size = regular ? std::filesystem::file_size(path, error) : 0;
  if (!error && size > max_bytes) throw MemoryError(size, max_bytes);
  return read_file(path, max_bytes);
}

Pixels pixels_of(const Format& format, Bytes bytes, uint64_t max_bytes) try {
  const Header header = format.checked(bytes);
  require_fits(header, bytes.size(), max_bytes);
  return decoded(format, header, bytes);
} catch (const BadImage& bad) {
  throw BadImage(std::string(bad.what()) + " (" + format.name + ")");
}

TransmittanceImage transmittance_from(Bytes bytes, uint64_t max_bytes) {
  const Format& format = recognized_format(bytes);
  const Pixels pixels = pixels_of(format, std::move(bytes), max_bytes);
  return interpreted(
      pixels, &format == &kExr ? roles_by_name(pixels.names) : roles_by_position(pixels.channels));
}

// Encoding.

/// Thresholds of an 8 x 8 ordered dither: each of (2 i + 1) / 128 once, evenly spread.
float dither_threshold(int x, int y) {
  unsigned rank = 0;
  const auto column = static_cast<unsigned>(x), mixed = static_cast<unsigned>(x ^ y);
  for (unsigned bit = 0; bit < 3; ++bit) {
    rank = rank << 2 | (mixed >> bit & 1) << 1 | (column >> bit & 1);
  }
  return (static_cast<float>(rank) + 0.5f) / 64;
}

float limited(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }

Bytes encoded_png(const OIIO::ImageSpec& spec, const void* pixels) {
  const auto output = OIIO::ImageOutput::create("png");
  if (!output) throw OutputError("PNG", one_line(OIIO::geterror()));
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  output->set_ioproxy(&memory);
  output->threads(1);
  const bool written = output->open("memory.png", spec) &&
                       output->write_image(spec.format, pixels) && output->close();
  if (!written) throw OutputError("PNG", one_line(output->geterror()));
  const auto bytes = std::as_bytes(std::span(encoded));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

TransmittanceImage read_transmittance(const std::filesystem::path& path, uint64_t max_bytes) {
  const std::string place = path.string();
  try {
    return transmittance_from(read_limited(path, max_bytes), max_bytes);
  } catch (const BadImage& bad) {
    throw InputError(place, bad.what());
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw MemoryError(max_bytes, max_bytes);
  } catch (const std::exception& error) {
    throw InputError(place, "the data are damaged: " + one_line(error.what()));
  }
}

std::vector<std::byte> encode_png_rgb8(const Image<std::array<float, 3>>& display_rgb) {
  if (display_rgb.empty()) throw OutputError("PNG", "the picture has no pixels");
  std::vector<uint8_t> samples;
  samples.reserve(display_rgb.values().size() * 3);
  for (int y = 0; y < display_rgb.height(); ++y) {
    for (int x = 0; x < display_rgb.width(); ++x) {
      for (const float value : display_rgb(x, y)) {
        samples.push_back(static_cast<uint8_t>(limited(value) * 255 + dither_threshold(x, y)));
      }
    }
  }
  OIIO::ImageSpec spec(display_rgb.width(), display_rgb.height(), 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  return encoded_png(spec, samples.data());
}

std::vector<std::byte> encode_png_gray16(const Image<float>& values) {
  if (values.empty()) throw OutputError("PNG", "the picture has no pixels");
  std::vector<uint16_t> samples;
  samples.reserve(values.values().size());
  for (const float value : values.values()) {
    samples.push_back(static_cast<uint16_t>(std::lround(limited(value) * 65535)));
  }
  const OIIO::ImageSpec spec(values.width(), values.height(), 1, OIIO::TypeDesc::UINT16);
  return encoded_png(spec, samples.data());
}

}  // namespace glare
