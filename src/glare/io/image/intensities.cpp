#include "glare/io/image/intensities.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "glare/io/image/decoder.h"
#include "glare/io/image/format.h"
#include "glare/io/image/loading.h"

namespace glare::image_io {

namespace {

/// Two numbers, v2f or v2d, among the attributes of an OpenEXR file; nothing where there are none.
std::optional<std::array<double, 2>> exr_pair(const Bytes& file, const std::string& name) try {
  Reader reader(file);
  reader.skip(8);
  for (std::string attribute = reader.text_z(); !attribute.empty(); attribute = reader.text_z()) {
    const std::string type = reader.text_z();
    const std::uint32_t size = reader.u32();
    if (attribute == name && type == "v2f" && size == 8)
      return std::array<double, 2>{std::bit_cast<float>(reader.u32()),
                                   std::bit_cast<float>(reader.u32())};
    if (attribute == name && type == "v2d" && size == 16)
      return std::array{std::bit_cast<double>(reader.number(8)),
                        std::bit_cast<double>(reader.number(8))};
    reader.skip(size);
  }
  return std::nullopt;
} catch (const BadImage&) {
  return std::nullopt;
}

/// The channel of the intensities, of one, of one and alpha, or by the name Y.
int channel_of(const Pixels& pixels, bool by_name, std::vector<std::string>& warnings) {
  const auto named = std::find(pixels.names.begin(), pixels.names.end(), "Y");
  const bool has_y = by_name && named != pixels.names.end();
  const bool has_alpha =
      by_name ? pixels.channels == 2 && !has_y && std::ranges::count(pixels.names, "A") == 1
              : pixels.channels == 2;
  if (!has_y && !has_alpha && pixels.channels != 1)
    throw BadImage("has " + std::to_string(pixels.channels) +
                   " channels; one of luminous intensities was expected");
  if (pixels.channels > 1) warnings.push_back("only one of the image's channels is used");
  if (has_y) return static_cast<int>(named - pixels.names.begin());
  return by_name && has_alpha && pixels.names[0] == "A" ? 1 : 0;
}

float checked_value(float value, int x, int y) {
  if (value >= 0 && value <= std::numeric_limits<float>::max()) return value;
  throw BadImage("pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                 ") is negative or not finite; candela were expected");
}

}  // namespace

bool is_picture(const Bytes& bytes) try {
  recognized_format(bytes);
  return true;
} catch (const BadImage&) {
  return false;
}

Intensities intensities_of(Bytes bytes, std::uint64_t max_bytes) {
  const Format& format = recognized_format(bytes);
  Intensities result;
  if (format.names_channels) {
    result.horizontal_range_deg = exr_pair(bytes, kHorizontalRangeTag);
    result.vertical_range_deg = exr_pair(bytes, kVerticalRangeTag);
  }
  const auto [header, pixels] = decoded_within(format, bytes, max_bytes, 1);
  result.has_whole_numbers = !header.linear_light;
  const int channel = channel_of(pixels, format.names_channels, result.warnings);
  require(pixels.width == pixels.full_width && pixels.height == pixels.full_height &&
              pixels.x == 0 && pixels.y == 0,
          "its data window isn't its display window");
  result.values = Image<float>(pixels.width, pixels.height);
  for (int y = 0; y < pixels.height; ++y)
    for (int x = 0; x < pixels.width; ++x)
      result.values(x, y) = checked_value(pixels(x, y, channel), x, y);
  return result;
}

}  // namespace glare::image_io
