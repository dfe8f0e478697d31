// Some rows of a picture's pixels at a time, as OpenEXR reads and writes them: the colours that are
// changed, and the channels that stay as they are. Internal.
#pragma once

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPartType.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "glare/picture/picture.h"

namespace glare::openexr_io {

/// Whether a part of a file that OpenEXR has read is of tiles: a part of scan lines may have their
/// description too.
inline bool is_tiled(const Imf::Header& header) { return header.type() == Imf::TILEDIMAGE; }

/// The channels that stay, each in the type it is stored in.
class KeptBand {
 public:
  /// Of all the header's channels but these, bands of `rows` rows.
  KeptBand(const Imf::Header& header, const std::vector<std::string>& changed, int rows);

  bool empty() const { return channels_.empty(); }
  /// Adds the slices of the band whose first row is `y` in the file.
  void add_slices(Imf::FrameBuffer& frame_buffer, int y);

 private:
  struct Channel {
    std::string name;
    Imf::Channel stored;
    std::size_t row_bytes = 0;
    std::vector<char> band;
  };
  int x_min_;
  std::vector<Channel> channels_;
};

/// The changed colours, in the types of the header's channels.
class ColorBand {
 public:
  ColorBand(const Imf::Header& header, const std::vector<std::string>& names,
            const Picture& picture, int rows);

  /// Converts `rows` rows from `y` in the file on, and adds their slices.
  void add_slices(Imf::FrameBuffer& frame_buffer, int y, int rows);
  /// The pixels so far that half precision couldn't hold.
  std::uint64_t limited_pixels() const { return limited_pixels_; }

 private:
  struct Channel {
    std::string name;
    bool half = false;
    const Image<float>* pixels = nullptr;
    Image<Imath::half> band;
  };
  void convert(int first_row, int rows);

  Imath::V2i min_;
  std::vector<Channel> channels_;
  std::uint64_t limited_pixels_ = 0;
};

}  // namespace glare::openexr_io
