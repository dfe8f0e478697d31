#include "glare/io/openexr/blocks.h"

#include <bit>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/image_header.h"

namespace glare::openexr_io {

using image_io::BadImage;
using image_io::Reader;
using image_io::require;
using std::uint64_t;

namespace {

enum Compression : unsigned { none, rle, zips, zip, piz, pxr24, b44, b44a, dwaa, dwab };

/// How long run-length coded data are when they are decoded.
uint64_t run_length_decoded_bytes(Reader data) {
  uint64_t bytes = 0;
  while (data.left() > 0) {
    const auto count = std::bit_cast<std::int8_t>(data.u8());
    data.skip(count < 0 ? static_cast<uint64_t>(-count) : 1);
    bytes += count < 0 ? static_cast<uint64_t>(-count) : static_cast<uint64_t>(count) + 1;
  }
  return bytes;
}

}  // namespace

BlockKind block_kind(unsigned compression) {
  constexpr uint64_t kDeflate = image_io::kDeflateRatio;
  switch (compression) {
    case none:
      return {1, 1};
    case rle:
      return {1, 64};  // 128 equal bytes become 2.
    case zips:
      return {1, kDeflate};
    case zip:
      return {16, kDeflate};
    case piz:
      return {32, kDeflate};  // 256 equal 16-bit numbers become 10 bits or more.
    case pxr24:
      return {16, kDeflate * 4 / 3};  // A byte of each 32-bit number goes before.
    case b44:
    case b44a:
      return {32, 11};  // 32 bytes become 3 or 14.
    case dwaa:
      return {32, 140000};  // 64 values may become 2 bytes, which are deflated.
    case dwab:
      return {256, 140000};
    default:
      throw BadImage("is compressed in an unknown way");
  }
}

void require_whole_block(std::span<const std::byte> data, uint64_t raw_bytes,
                         unsigned compression) {
  require(data.size() <= raw_bytes, "a block of pixels is damaged");
  if (data.size() == raw_bytes) return;
  require(compression != none, "a block of pixels is cut short");
  require(raw_bytes <= data.size() * block_kind(compression).ratio,
          "a block of pixels has too little data");
  if (compression == rle)
    require(run_length_decoded_bytes(Reader(data)) == raw_bytes, "a block of pixels is damaged");
}

}  // namespace glare::openexr_io
