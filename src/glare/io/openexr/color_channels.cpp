#include "glare/io/openexr/color_channels.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "glare/io/image/image_header.h"
#include "glare/io/openexr/rgb_pixels.h"

namespace glare::openexr_io {

using image_io::BadImage;

namespace {

using Names = std::vector<std::string>;

constexpr std::array<std::array<const char*, 3>, 4> kTriples = {
    {{"R", "G", "B"}, {"r", "g", "b"}, {"red", "green", "blue"}, {"X", "Y", "Z"}}};

Names names_of(const Imf::ChannelList& channels) {
  Names names;
  for (auto c = channels.begin(); c != channels.end(); ++c) names.emplace_back(c.name());
  return names;
}

bool has(const Imf::ChannelList& channels, const std::string& name) {
  return channels.findChannel(name) != nullptr;
}

/// The part of a channel's name before the last dot; empty where there is none.
std::string layer_of(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(0, dot);
}

std::string own_name(const std::string& name) { return name.substr(name.rfind('.') + 1); }

/// Depth, near and far.
bool is_depth(const std::string& own) { return own == "Z" || own == "ZBack"; }

bool is_alpha(const std::string& own) {
  return own == "A" || own == "a" || own == "alpha" || own == "AR" || own == "AG" || own == "AB";
}

std::optional<ColorChannels> three_channels(const Imf::ChannelList& channels,
                                            const std::string& layer) {
  for (const auto& triple : kTriples) {
    ColorChannels color;
    for (const char* name : triple) color.names.push_back(name_in_layer(layer, name));
    color.is_xyz = triple[0] == std::string("X");
    if (std::ranges::all_of(color.names, [&](const auto& name) { return has(channels, name); }))
      return color;
  }
  return {};
}

std::optional<ColorChannels> lone_channel(const Imf::ChannelList& channels,
                                          const std::string& layer) {
  if (const std::string y = name_in_layer(layer, "Y"); has(channels, y)) return ColorChannels{{y}};
  if (!layer.empty() && has(channels, layer)) return ColorChannels{{layer}};
  Names own;
  for (const std::string& name : names_of(channels))
    if ((layer.empty() || layer_of(name) == layer) && !is_alpha(own_name(name)) &&
        !is_depth(own_name(name)))
      own.push_back(name);
  if (own.size() == 1) return ColorChannels{own};
  return {};
}

/// For a message; only as many as a line may have.
std::string joined(const std::set<std::string>& names) {
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (++count > 20) return text + ", ...";
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

[[noreturn]] void refuse(const Imf::ChannelList& channels, const std::string& layer) {
  const Names names = names_of(channels);
  std::set<std::string> layers;
  for (const std::string& name : names)
    if (const std::string other = layer_of(name);
        !other.empty() && (three_channels(channels, other) || lone_channel(channels, other)))
      layers.insert(other);
  if (layer.empty() && layers.empty())
    throw BadImage("has channels " + joined({names.begin(), names.end()}) +
                   "; R, G and B, or Y, or a single one is expected");
  const std::string missing =
      layer.empty() ? "has no channels R, G and B" : "has no colours in a layer " + layer;
  throw BadImage(missing + (layers.empty() ? ", nor any layer" : "; its layers are ") +
                 joined(layers));
}

void require_light(const Imf::ChannelList& channels, const std::string& name) {
  const Imf::Channel& channel = *channels.findChannel(name);
  if (channel.type == Imf::UINT)
    throw BadImage("channel " + name + " holds whole numbers (identities, not light)");
  if (channel.xSampling != 1 || channel.ySampling != 1)
    throw BadImage("channel " + name + " is subsampled; a value for each pixel was expected");
}

}  // namespace

ColorChannels color_channels(const Imf::ChannelList& channels, const std::string& layer) {
  auto color = three_channels(channels, layer);
  if (!color &&
      (has(channels, name_in_layer(layer, "RY")) || has(channels, name_in_layer(layer, "BY"))))
    throw BadImage("holds luminance and subsampled colour (Y, RY, BY); R, G and B were expected");
  if (!color) color = lone_channel(channels, layer);
  if (!color) refuse(channels, layer);
  for (const std::string& name : color->names) require_light(channels, name);
  return *color;
}

}  // namespace glare::openexr_io
