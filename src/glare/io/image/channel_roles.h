// What the channels of a decoded picture are. Formats without names of channels have them in a
// fixed order (grey, grey and alpha, RGB, RGBA); OpenEXR has them by name, in any number. Internal.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "glare/io/image/decoder.h"

namespace glare::image_io {

/// Which channels are what; -1: there is none.
struct ChannelRoles {
  std::array<int, 3> color = {-1, -1, -1};  ///< The second and third are -1 for a grey picture.
  int alpha = -1;
  bool others = false;  ///< There are further channels.

  bool grey() const { return color[1] < 0; }
  /// The channel to be taken for colour `k`: of a grey picture always the same.
  int of(std::size_t k) const { return color[grey() ? 0 : k]; }
};

/// The roles by the channels' names, or by their places. Throws `BadImage` for other channels than
/// one, three, or these and alpha.
ChannelRoles channel_roles(const Pixels& pixels, bool by_name);

/// The same where the channels X, Y and Z are colours too, if there are no R, G and B. `is_xyz`
/// tells that they are.
ChannelRoles color_channel_roles(const Pixels& pixels, bool by_name, bool& is_xyz);

bool is_constant(const Pixels& pixels, int channel);

/// What is said where there are other channels.
std::string unused_channels_warning(const Pixels& pixels);

/// Calls `use(column, row)`, of what is stored, for each pixel that lies in the whole picture.
template <typename Use>
void for_each_shown_pixel(const Pixels& pixels, const Use& use) {
  const int last_row = std::min(pixels.height, pixels.full_height - pixels.y);
  const int last_column = std::min(pixels.width, pixels.full_width - pixels.x);
  for (int row = std::max(0, -pixels.y); row < last_row; ++row)
    for (int column = std::max(0, -pixels.x); column < last_column; ++column) use(column, row);
}

}  // namespace glare::image_io
