#include "glare/io/openexr/inflated.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include "glare/io/image/image_header.h"

namespace glare::openexr_io {

namespace {

class Inflation {
 public:
  Inflation() {
    if (inflateInit(&stream_) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { inflateEnd(&stream_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  /// The size, or more than `most` where it is larger; 0 where the data are damaged.
  std::uint64_t size(std::span<const std::byte> data, std::uint64_t most) {
    std::array<Bytef, 1 << 15> piece;
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(data.data()));
    stream_.avail_in = static_cast<uInt>(data.size());
    std::uint64_t size = 0;
    for (int state = Z_OK; state != Z_STREAM_END && size <= most;) {
      stream_.next_out = piece.data();
      stream_.avail_out = piece.size();
      state = inflate(&stream_, Z_NO_FLUSH);
      size += piece.size() - stream_.avail_out;
      if (state != Z_OK && state != Z_STREAM_END) return 0;
    }
    return size;
  }

 private:
  z_stream stream_{};
};

}  // namespace

void require_inflates_to(std::span<const std::byte> data, std::uint64_t size) {
  image_io::require(
      data.size() <= std::numeric_limits<uInt>::max() && Inflation().size(data, size) == size,
      "a block of pixels is damaged");
}

void inflate_to(std::span<const std::byte> data, std::span<std::byte> result) {
  auto size = static_cast<uLongf>(result.size());
  const int state =
      uncompress(reinterpret_cast<Bytef*>(result.data()), &size,
                 reinterpret_cast<const Bytef*>(data.data()), static_cast<uLong>(data.size()));
  image_io::require(state == Z_OK && size == result.size(), "a block of pixels is damaged");
}

}  // namespace glare::openexr_io
