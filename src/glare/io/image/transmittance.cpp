// What channels mean. Formats without names of channels have them in a fixed order (grey, grey and
// alpha, RGB, RGBA); OpenEXR has them by name, in any number.
#include "glare/io/image/transmittance.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string_view>

#include "glare/io/image/image_header.h"

namespace glare::image_io {

namespace {

constexpr float kLargestAccepted = 1.0f + 1e-3f;  // Rounding of whoever wrote the file.

/// Which channels are what; -1: there is none.
struct Roles {
  std::array<int, 3> color = {-1, -1, -1};  ///< The second and third are -1 for a grey picture.
  int alpha = -1;
  bool others = false;  ///< There are further channels.

  bool grey() const { return color[1] < 0; }
};

Roles roles_by_position(int channels) {
  if (channels < 1 || channels > 4) {
    throw BadImage("has " + std::to_string(channels) + " channels; 1 to 4 are expected");
  }
  Roles roles;
  roles.color = channels >= 3 ? std::array{0, 1, 2} : std::array{0, -1, -1};
  if (channels % 2 == 0) roles.alpha = channels - 1;
  return roles;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

Roles roles_by_name(const std::vector<std::string>& names) {
  const auto find = [&](std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
  };
  Roles roles;
  roles.alpha = find("A");
  const std::size_t known_alpha = roles.alpha >= 0 ? 1 : 0;
  if (find("R") >= 0 && find("G") >= 0 && find("B") >= 0) {
    roles.color = {find("R"), find("G"), find("B")};
    roles.others = names.size() > 3 + known_alpha;
  } else if (find("Y") >= 0) {
    roles.color[0] = find("Y");
    roles.others = names.size() > 1 + known_alpha;
  } else if (names.size() == 1) {
    return {{0, -1, -1}, -1, false};
  } else if (names.size() == 2 && roles.alpha >= 0) {
    roles.color[0] = 1 - roles.alpha;
  } else {
    throw BadImage("has channels " + one_line(joined(names)) +
                   "; R, G and B, or Y, or a single one is expected");
  }
  return roles;
}

bool is_constant(const Pixels& pixels, int channel) {
  const auto step = static_cast<std::size_t>(pixels.channels);
  const auto offset = static_cast<std::size_t>(channel);
  for (std::size_t i = offset; i < pixels.values.size(); i += step) {
    if (pixels.values[i] != pixels.values[offset]) return false;
  }
  return true;
}

bool only_alpha_varies(const Pixels& pixels, const Roles& roles) {
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

Image<float> transmittance_of(const Pixels& pixels, const Roles& roles) {
  Image<float> image(pixels.full_width, pixels.full_height);
  const auto value_at = [&](int column, int row, int channel) {
    return checked_value(pixels(column, row, channel), pixels.x + column, pixels.y + row);
  };
  const int last_row = std::min(pixels.height, pixels.full_height - pixels.y);
  const int last_column = std::min(pixels.width, pixels.full_width - pixels.x);
  for (int row = std::max(0, -pixels.y); row < last_row; ++row) {
    for (int column = std::max(0, -pixels.x); column < last_column; ++column) {
      const float first = value_at(column, row, roles.color[0]);
      image(pixels.x + column, pixels.y + row) =
          roles.grey() ? first
                       : std::min(1.0f, luminance(first, value_at(column, row, roles.color[1]),
                                                  value_at(column, row, roles.color[2])));
    }
  }
  return image;
}

}  // namespace

TransmittanceImage interpreted(const Pixels& pixels, bool by_name) {
  Roles roles = by_name ? roles_by_name(pixels.names) : roles_by_position(pixels.channels);
  TransmittanceImage result;
  if (only_alpha_varies(pixels, roles)) {
    roles.color = {roles.alpha, -1, -1};
  } else if (roles.alpha >= 0) {
    result.warnings.push_back("the alpha channel is ignored");
  }
  if (roles.others) {
    result.warnings.push_back("only some of the channels " + one_line(joined(pixels.names)) +
                              " are used");
  }
  result.transmittance = transmittance_of(pixels, roles);
  return result;
}

Photograph photograph_of(const Pixels& pixels, bool by_name) {
  const Roles roles = by_name ? roles_by_name(pixels.names) : roles_by_position(pixels.channels);
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
  const int last_row = std::min(pixels.height, pixels.full_height - pixels.y);
  const int last_column = std::min(pixels.width, pixels.full_width - pixels.x);
  for (int row = std::max(0, -pixels.y); row < last_row; ++row)
    for (int column = std::max(0, -pixels.x); column < last_column; ++column)
      for (std::size_t k = 0; k < 3; ++k)
        result.rgb(pixels.x + column, pixels.y + row)[k] =
            value_at(column, row, roles.color[roles.grey() ? 0 : k]);
  for (auto& pixel : result.rgb.values())
    for (float& value : pixel) value /= largest;
  if (roles.alpha >= 0) result.warnings.push_back("the alpha channel is ignored");
  return result;
}

}  // namespace glare::image_io
