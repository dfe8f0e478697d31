#include "glare/io/picture_file.h"

#include <OpenEXR/ImfStringAttribute.h>

#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "glare/base/error.h"
#include "glare/color/srgb.h"
#include "glare/io/file_color_space.h"
#include "glare/io/image/channel_roles.h"
#include "glare/io/image/loading.h"
#include "glare/io/image/text_tags.h"
#include "glare/io/openexr/rgb_pixels.h"

namespace glare {

using image_io::BadImage;
using image_io::Bytes;
using image_io::ChannelRoles;
using image_io::Pixels;

namespace {

constexpr const char* kColorSpaceAttribute = "glare:colorSpace";

/// What the file tells of its R, G and B.
RgbColorSpace space_in(const Bytes& file) {
  const auto numbers = image_io::exr_chromaticities(file);
  if (!numbers) return lin_rec709_color_space();
  FileChromaticities c;
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = {(*numbers)[2 * k], (*numbers)[2 * k + 1]};
  return color_space_with(c, image_io::exr_text(file, kColorSpaceAttribute).value_or(""));
}

// Pixels.

void require_finite(const Pixels& pixels, const ChannelRoles& roles) {
  std::uint64_t count = 0;
  int first_x = 0, first_y = 0;
  image_io::for_each_shown_pixel(pixels, [&](int column, int row) {
    bool finite = true;
    for (std::size_t k = 0; k < 3; ++k)
      finite = finite && std::isfinite(pixels(column, row, roles.of(k)));
    if (finite) return;
    if (count == 0) first_x = pixels.x + column, first_y = pixels.y + row;
    ++count;
  });
  if (count > 0)
    throw BadImage("pixel (" + std::to_string(first_x) + ", " + std::to_string(first_y) +
                   ") isn't finite, the first of " + std::to_string(count));
}

std::array<Image<float>, 3> channels_of(const Pixels& pixels, const ChannelRoles& roles,
                                        bool linear_light) {
  std::array<Image<float>, 3> channels;
  channels.fill(Image<float>(pixels.full_width, pixels.full_height));
  image_io::for_each_shown_pixel(pixels, [&](int column, int row) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float value = pixels(column, row, roles.of(k));
      channels[k](pixels.x + column, pixels.y + row) =
          linear_light ? value : static_cast<float>(linear_from_srgb(value));
    }
  });
  return channels;
}

PictureFile picture_from(Bytes bytes, std::uint64_t max_bytes) {
  const image_io::Format& format = image_io::recognized_format(bytes);
  const RgbColorSpace rgb_space = space_in(bytes);
  const auto [header, pixels] = image_io::decoded_within(format, bytes, max_bytes, 3);
  bool is_xyz = false;
  const ChannelRoles roles = image_io::color_channel_roles(pixels, format.names_channels, is_xyz);
  require_finite(pixels, roles);
  PictureFile file;
  file.picture = {channels_of(pixels, roles, header.linear_light),
                  is_xyz ? xyz_color_space() : rgb_space};
  file.was_display_encoded = !header.linear_light;
  if (roles.alpha >= 0 && !image_io::is_constant(pixels, roles.alpha))
    file.warnings.push_back("the alpha channel is ignored");
  if (roles.others) file.warnings.push_back(image_io::unused_channels_warning(pixels));
  return file;
}

// Layers.

void require_layer_name(const std::string& name) {
  // OpenEXR's names have 255 characters at most, and the channel's own takes two.
  if (name.size() > 253 || name.starts_with('.') || name.ends_with('.') ||
      name.find("..") != std::string::npos || name.find('\0') != std::string::npos)
    throw OptionError("\"" + name + "\" can't be a layer's name");
}

void require_writable_layers(const std::filesystem::path& path,
                             std::span<const PictureLayer> layers,
                             const PictureFileOptions& options) {
  if (layers.empty() || layers[0].picture->channels[0].empty())
    throw OutputError(path.string(), "the picture has no pixels");
  const Picture& first = *layers[0].picture;
  std::set<std::string> names;
  for (const auto& [name, picture, alpha] : layers) {
    require_layer_name(name);
    if (!names.insert(name).second) throw OptionError("two layers have the name \"" + name + "\"");
    if (picture->width() != first.width() || picture->height() != first.height() ||
        (alpha && (alpha->width() != first.width() || alpha->height() != first.height())))
      throw OptionError("the layers of a picture are of different sizes");
    if (picture->color_space.rgb_from_xyz() != first.color_space.rgb_from_xyz())
      throw OptionError("the layers of a picture are in different colour spaces");
    if (options.half && !(openexr_io::fits_half(picture->channels) &&
                          (!alpha || openexr_io::fits_half({*alpha, {}, {}}))))
      throw OptionError(
          "half precision holds values up to 65504 and this picture has larger ones; write 32-bit "
          "floating point");
  }
}

}  // namespace

PictureFile read_picture(const std::filesystem::path& path, std::uint64_t max_bytes) {
  return image_io::read_with(path, max_bytes, picture_from);
}

void write_picture(const std::filesystem::path& path, const Picture& picture,
                   const PictureFileOptions& options) {
  const PictureLayer layer = {"", &picture, nullptr};
  write_picture_layers(path, {&layer, 1}, options);
}

void write_picture_layers(const std::filesystem::path& path, std::span<const PictureLayer> layers,
                          const PictureFileOptions& options) {
  require_writable_layers(path, layers, options);
  const Picture& first = *layers[0].picture;
  std::vector<openexr_io::RgbLayer> stored;
  for (const PictureLayer& layer : layers)
    stored.push_back({layer.name, &layer.picture->channels, layer.alpha});
  Imf::Header header = openexr_io::rgb_header(first.width(), first.height(), first.color_space,
                                              options.half, stored);
  header.insert(kColorSpaceAttribute, Imf::StringAttribute(first.color_space.name()));
  header.insert("glare:software", Imf::StringAttribute("glare " GLARE_VERSION));
  for (const auto& [name, text] : options.attributes)
    header.insert(name, Imf::StringAttribute(text));
  openexr_io::write_rgb_layers(path, header, first.color_space, stored,
                               {options.half, options.threads, options.keep_going});
}

}  // namespace glare
