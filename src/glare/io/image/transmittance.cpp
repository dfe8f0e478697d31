#include "glare/io/image/transmittance.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "glare/io/image/channel_roles.h"
#include "glare/io/image/image_header.h"

namespace glare::image_io {

namespace {

constexpr float kLargestAccepted = 1.0f + 1e-3f;  // Rounding of whoever wrote the file.

bool only_alpha_varies(const Pixels& pixels, const ChannelRoles& roles) {
  if (roles.alpha < 0 || is_constant(pixels, roles.alpha)) return false;
  return std::all_of(roles.color.begin(), roles.color.end(),
                     [&](int channel) { return channel < 0 || is_constant(pixels, channel); });
}

float checked_value(float value, int x, int y) {
  if (value >= 0 && value <= kLargestAccepted) return std::min(value, 1.0f);
  char number[32];
  std::snprintf(number, sizeof number, "%.6g", static_cast<double>(value));
  throw BadImage("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") is " + number +
                 "; a transmittance from 0 to 1 is expected");
}

float luminance(float red, float green, float blue) {
  if (red == green && green == blue) return red;
  return static_cast<float>(0.2126 * red + 0.7152 * green + 0.0722 * blue);
}

Image<float> transmittance_of(const Pixels& pixels, const ChannelRoles& roles) {
  Image<float> image(pixels.full_width, pixels.full_height);
  const auto value_at = [&](int column, int row, int channel) {
    return checked_value(pixels(column, row, channel), pixels.x + column, pixels.y + row);
  };
  for_each_shown_pixel(pixels, [&](int column, int row) {
    const float first = value_at(column, row, roles.color[0]);
    image(pixels.x + column, pixels.y + row) =
        roles.grey() ? first
                     : std::min(1.0f, luminance(first, value_at(column, row, roles.color[1]),
                                                value_at(column, row, roles.color[2])));
  });
  return image;
}

}  // namespace

TransmittanceImage interpreted(const Pixels& pixels, bool by_name) {
  ChannelRoles roles = channel_roles(pixels, by_name);
  TransmittanceImage result;
  if (only_alpha_varies(pixels, roles)) {
    roles.color = {roles.alpha, -1, -1};
  } else if (roles.alpha >= 0) {
    result.warnings.push_back("the alpha channel is ignored");
  }
  if (roles.others) result.warnings.push_back(unused_channels_warning(pixels));
  result.transmittance = transmittance_of(pixels, roles);
  return result;
}

Photograph photograph_of(const Pixels& pixels, bool by_name) {
  const ChannelRoles roles = channel_roles(pixels, by_name);
  Photograph result;
  result.rgb = RgbImage(pixels.full_width, pixels.full_height);
  float largest = 1;
  const auto value_at = [&](int column, int row, int channel) {
    const float value = pixels(column, row, channel);
    if (!(value >= 0 && value <= std::numeric_limits<float>::max()))
      throw BadImage("pixel (" + std::to_string(pixels.x + column) + ", " +
                     std::to_string(pixels.y + row) + ") is negative or not a number");
    largest = std::max(largest, value);
    return value;
  };
  for_each_shown_pixel(pixels, [&](int column, int row) {
    for (std::size_t k = 0; k < 3; ++k)
      result.rgb(pixels.x + column, pixels.y + row)[k] = value_at(column, row, roles.of(k));
  });
  for (auto& pixel : result.rgb.values())
    for (float& value : pixel) value /= largest;
  if (roles.alpha >= 0) result.warnings.push_back("the alpha channel is ignored");
  return result;
}

}  // namespace glare::image_io
