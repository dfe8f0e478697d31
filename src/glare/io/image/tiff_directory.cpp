// The tags are walked through here, so that texts, profiles, private tags and further directories
// never reach libtiff: it gets a directory with only the tags listed here.
#include "glare/io/image/tiff_directory.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace glare::image_io {

using std::uint16_t;
using std::uint32_t;
using std::uint64_t;

namespace {

constexpr std::array<uint16_t, 19> kTiffTags = {
    kImageWidth,   kImageLength,    kBitsPerSample,   kCompression,  kPhotometric,
    kFillOrder,    kStripOffsets,   kSamplesPerPixel, kRowsPerStrip, kStripByteCounts,
    kPlanarConfig, kPredictor,      kColorMap,        kTileWidth,    kTileLength,
    kTileOffsets,  kTileByteCounts, kExtraSamples,    kSampleFormat};

constexpr uint64_t kMaxCount = uint64_t{1} << 22;  // Strips or tiles of a picture.

/// Bytes of a whole number of this type; 0 for other types.
std::size_t size_of_type(uint16_t type) {
  return type == 1 ? 1 : type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
}

}  // namespace

TiffDirectory::TiffDirectory(const Bytes& bytes)
    : order_(starts_with(bytes, "MM") ? std::endian::big : std::endian::little) {
  Reader reader(bytes, order_);
  reader.skip(2);
  big_ = reader.u16() == 43;
  if (big_) require(reader.u16() == 8 && reader.u16() == 0, "the header is damaged");
  reader.seek(reader.number(word()));
  const uint64_t count = reader.number(big_ ? 8 : 2);
  require(count <= 4096, "the directory is damaged");
  for (uint64_t i = 0; i < count; ++i) take_entry(reader, bytes);
  if (!has(kBitsPerSample)) replace(kBitsPerSample, 1);  // OpenImageIO would take it for 8.
}

std::vector<uint64_t> TiffDirectory::numbers(uint16_t tag, uint64_t otherwise) const {
  const auto found = entries_.find(tag);
  return found == entries_.end() ? std::vector<uint64_t>{otherwise} : found->second.numbers;
}

void TiffDirectory::replace(uint16_t tag, uint64_t value) {
  Entry entry{{}, {value}, 0};
  append_number(entry.stored, tag, 2, order_);
  append_number(entry.stored, 3, 2, order_);
  append_number(entry.stored, 1, word(), order_);
  append_number(entry.stored, value, 2, order_);
  entry.stored.resize(4 + 2 * word());
  entries_.insert_or_assign(tag, std::move(entry));
}

void TiffDirectory::round_palette(Bytes& bytes) const {
  const auto found = entries_.find(kColorMap);
  if (found == entries_.end() || found->second.position == 0) return;
  Bytes rounded;
  for (const uint64_t color : found->second.numbers) {
    append_number(rounded, (color >> 8) * 257, 2, order_);
  }
  std::copy(rounded.begin(), rounded.end(),
            bytes.begin() + static_cast<std::ptrdiff_t>(found->second.position));
}

void TiffDirectory::append_to(Bytes& bytes) const {
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

void TiffDirectory::take_entry(Reader& reader, const Bytes& bytes) {
  const auto stored = reader.take(4 + 2 * word());
  Reader entry(stored, order_);
  const uint16_t tag = entry.u16();
  if (std::find(kTiffTags.begin(), kTiffTags.end(), tag) == kTiffTags.end()) return;
  const std::size_t size = size_of_type(entry.u16());
  require(size != 0 && (size != 8 || big_), "a tag has the wrong type");
  const uint64_t count = entry.number(word());
  require(count >= 1 && count <= kMaxCount, "a tag is damaged");
  require(tag != kColorMap || size == 2, "a tag has the wrong type");
  require(!has(tag), "has a tag twice");
  Entry kept{Bytes(stored.begin(), stored.end()), {}, 0};
  Reader values = entry;
  if (count * size > word()) {
    values = Reader(bytes, order_);
    values.seek(entry.number(word()));
    kept.position = values.position();
  }
  for (uint64_t i = 0; i < count; ++i) kept.numbers.push_back(values.number(size));
  entries_.emplace(tag, std::move(kept));
}

}  // namespace glare::image_io
