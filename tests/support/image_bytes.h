// Bytes of small picture files, put together by hand: other than files that a library writes, they
// can be wrong in any way.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace glare::test {

/// A whole number of `size` bytes, the lowest first.
std::string little(std::uint64_t value, int size);
/// The same, the highest first.
std::string big(std::uint64_t value, int size);
/// Floats of 4 bytes, the lowest first.
std::string float_bytes(float value);
std::string floats(const std::vector<float>& values);

/// `bytes` as a zlib stream that is not compressed.
std::string stored(const std::string& bytes);
/// A chunk of a PNG file, with the right checksum.
std::string png_chunk(const std::string& type, const std::string& content);

struct Png {
  std::uint32_t width = 2, height = 1;
  int bits = 8, color_type = 0;
  std::string pixels;      ///< Each row starts with its filter, 0.
  std::string extra = "";  ///< Chunks before the pixels.
};

std::string png(const Png& p);

struct TiffTag {
  int tag, type;  ///< Types: 3 is 16-bit, 4 is 32-bit.
  std::vector<std::uint32_t> values;
};

/// A TIFF file with the pixels as one strip; tags must be in order.
std::string tiff(std::vector<TiffTag> tags, const std::string& pixels, bool big_endian = false);
/// The tags of a grey picture as one strip of `size` bytes; of 32 bits, it holds floats.
std::vector<TiffTag> tiff_tags(std::uint32_t width, std::uint32_t height, std::uint32_t bits,
                               std::uint32_t size);
/// The entry of this number, which has to be there.
TiffTag& tag_of(std::vector<TiffTag>& tags, int tag);

/// A BMP file without compression. A palette has 4 bytes a colour; rows are filled to 4 bytes.
std::string bmp(int width, int height, int bits, const std::string& palette,
                const std::string& rows);

/// A Radiance HDR file; `size` is its line, like "-Y 1 +X 2".
std::string hdr(const std::string& size, const std::string& pixels);

/// An attribute in the header of an OpenEXR file.
std::string attribute(const std::string& name, const std::string& type, const std::string& value);

struct Exr {
  std::vector<std::string> channels = {"Y"};  ///< In alphabetical order.
  int x = 0, y = 0, width = 2, height = 1;    ///< The data window.
  int full_width = 2, full_height = 1;        ///< The display window, from (0, 0).
  std::vector<float> rows;                    ///< Row by row, and in a row channel by channel.
  int sampling = 1, flags = 0, channel_type = 2;
  std::string extra = "";  ///< Attributes.
};

/// An uncompressed OpenEXR file of floats.
std::string exr(const Exr& e);

}  // namespace glare::test
