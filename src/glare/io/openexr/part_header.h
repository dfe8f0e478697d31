// What the header of a part of an OpenEXR file says of its sizes, read before OpenEXR sees it.
// Internal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "glare/io/image/byte_reader.h"

namespace glare::openexr_io {

struct PartHeader {
  bool deep = false;
  bool tiled = false;
  bool has_type = false;  ///< The attribute; where it is missing the file's version tells.
  std::int64_t x_min = 0, y_min = 0;
  std::uint64_t width = 0, height = 0;  ///< Of the data window.
  unsigned compression = 0;
  std::uint64_t chunk_count = 0;  ///< As stated; 0 where it isn't.

  struct Channel {
    std::string name;
    unsigned type = 0;        ///< 0: uint, 1: half, 2: float.
    std::uint64_t bytes = 0;  ///< Of a value.
    std::int64_t x_sampling = 1, y_sampling = 1;
  };
  std::vector<Channel> channels;

  struct Tiles {
    std::uint64_t width = 0, height = 0;
    enum { one_level, mipmap, ripmap } levels = one_level;
    bool round_up = false;
  };
  Tiles tiles;

  /// Of all channels, for a pixel that has a value in each.
  std::uint64_t pixel_bytes() const;
};

struct FileHeaders {
  bool multi_part = false;
  std::vector<PartHeader> parts;
};

/// The headers; the reader is left where the tables of the blocks begin. Every attribute lies
/// within the file and is as long as its type says. Throws `image_io::BadImage`.
FileHeaders part_headers(image_io::Reader& reader);

}  // namespace glare::openexr_io
