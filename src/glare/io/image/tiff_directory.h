// The tags of a TIFF file. Internal.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "glare/io/image/byte_reader.h"

namespace glare::image_io {

enum TiffTag : std::uint16_t {
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

/// The first directory of a TIFF file, classic or big, reduced to the tags that pixels need: those
/// of `TiffTag`. Numbers are read when it is made; `bytes` has to live as long as the directory is
/// being made.
class TiffDirectory {
 public:
  /// Throws `BadImage` where the directory or a tag of it is damaged or cut short.
  explicit TiffDirectory(const Bytes& bytes);

  bool has(std::uint16_t tag) const { return entries_.contains(tag); }

  /// The numbers of a tag; `otherwise` alone if the tag is missing.
  std::vector<std::uint64_t> numbers(std::uint16_t tag, std::uint64_t otherwise) const;
  /// The first of them.
  std::uint64_t number(std::uint16_t tag, std::uint64_t otherwise) const {
    return numbers(tag, otherwise).front();
  }

  /// Gives a tag this number alone.
  void replace(std::uint16_t tag, std::uint64_t value);

  /// Makes the colours of a palette in `bytes`, the file, multiples of 257: OpenImageIO rounds down
  /// what lies between, and some writers use multiples of 256.
  void round_palette(Bytes& bytes) const;

  /// Adds to `bytes`, the file, a directory of only these tags, and makes it the file's only one.
  void append_to(Bytes& bytes) const;

 private:
  struct Entry {
    Bytes stored;
    std::vector<std::uint64_t> numbers;
    std::size_t position = 0;  ///< Of the numbers, in the file; 0 if they are in the entry.
  };

  std::size_t word() const { return big_ ? 8 : 4; }
  void take_entry(Reader& reader, const Bytes& bytes);

  std::endian order_;
  bool big_ = false;
  std::map<std::uint16_t, Entry> entries_;
};

}  // namespace glare::image_io
