#include "glare/io/image/channel_roles.h"

#include <string_view>
#include <vector>

#include "glare/io/image/image_header.h"

namespace glare::image_io {

namespace {

using Names = std::vector<std::string>;

int place_of(const Names& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

bool has_all(const Names& names, const std::array<const char*, 3>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](const char* name) { return place_of(names, name) >= 0; });
}

ChannelRoles roles_by_position(int channels) {
  if (channels < 1 || channels > 4) {
    throw BadImage("has " + std::to_string(channels) + " channels; 1 to 4 are expected");
  }
  ChannelRoles roles;
  roles.color = channels >= 3 ? std::array{0, 1, 2} : std::array{0, -1, -1};
  if (channels % 2 == 0) roles.alpha = channels - 1;
  return roles;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

ChannelRoles roles_by_name(const std::vector<std::string>& names) {
  ChannelRoles roles;
  roles.alpha = place_of(names, "A");
  const std::size_t known_alpha = roles.alpha >= 0 ? 1 : 0;
  if (has_all(names, {"R", "G", "B"})) {
    roles.color = {place_of(names, "R"), place_of(names, "G"), place_of(names, "B")};
    roles.others = names.size() > 3 + known_alpha;
  } else if (place_of(names, "Y") >= 0) {
    roles.color[0] = place_of(names, "Y");
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

}  // namespace

ChannelRoles channel_roles(const Pixels& pixels, bool by_name) {
  return by_name ? roles_by_name(pixels.names) : roles_by_position(pixels.channels);
}

ChannelRoles color_channel_roles(const Pixels& pixels, bool by_name, bool& is_xyz) {
  const Names& names = pixels.names;
  is_xyz = by_name && has_all(names, {"X", "Y", "Z"}) && !has_all(names, {"R", "G", "B"});
  if (!is_xyz) return channel_roles(pixels, by_name);
  ChannelRoles roles{{place_of(names, "X"), place_of(names, "Y"), place_of(names, "Z")},
                     place_of(names, "A")};
  roles.others = names.size() > (roles.alpha >= 0 ? 4 : 3);
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

std::string unused_channels_warning(const Pixels& pixels) {
  return "only some of the channels " + one_line(joined(pixels.names)) + " are used";
}

}  // namespace glare::image_io
