// Decoding and encoding of pictures whose structure is checked. Internal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/format.h"
#include "glare/io/image/image_header.h"

namespace glare::image_io {

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

/// The pixels of a file whose structure is checked, and that fits: `header` is what the check
/// returned, `bytes` what it left. Throws `BadImage` where they can't be decoded or are not what
/// `header` says.
Pixels decoded(const Format& format, const Header& header, Bytes& bytes);

/// A PNG file of `width` x `height` x 3 samples, tagged sRGB. Throws `OutputError`.
Bytes encoded_png_rgb8(int width, int height, std::span<const std::uint8_t> samples);

/// The same of 16 bits.
Bytes encoded_png_rgb16(int width, int height, std::span<const std::uint16_t> samples);

/// A PNG file of `width` x `height` samples. Throws `OutputError`.
Bytes encoded_png_gray16(int width, int height, std::span<const std::uint16_t> samples);

/// The same of 8 bits.
Bytes encoded_png_gray8(int width, int height, std::span<const std::uint8_t> samples);

/// A message of a decoder as one line; a common one where there is none.
std::string one_line(std::string message);

}  // namespace glare::image_io
