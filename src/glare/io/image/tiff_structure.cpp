// What kind of picture a TIFF file holds, and whether its pixels are all there. A directory of a
// few bytes can ask for any number of channels, strips and bytes, which decoders then allocate;
// some kinds they convert wrongly or by guess. So only plain kinds pass, with the strips inside the
// file, and the file gets a new directory of only the tags that pixels need.
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/structure.h"
#include "glare/io/image/tiff_directory.h"

namespace glare::image_io {

using std::uint64_t;

namespace {

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

}  // namespace

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
  header.linear_light = directory.number(kSampleFormat, 1) == 3;
  if (directory.number(kPhotometric, 1) == 3) directory.round_palette(bytes);
  if (directory.number(kPhotometric, 1) == 0) {
    // OpenImageIO turns some kinds of samples and leaves others.
    header.zero_is_white = true;
    directory.replace(kPhotometric, 1);
  }
  directory.append_to(bytes);
  return header;
}

}  // namespace glare::image_io
