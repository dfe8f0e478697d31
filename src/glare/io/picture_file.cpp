#include "glare/io/picture_file.h"

#include <OpenEXR/ImfStringAttribute.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "glare/base/error.h"
#include "glare/color/srgb.h"
#include "glare/io/built_in_color_spaces.h"
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

// Colour spaces.

/// Red, green, blue and white.
using Chromaticities = std::array<Chromaticity, 4>;

Chromaticities chromaticities_of(const RgbColorSpace& space) {
  const auto [red, green, blue] = space.primaries();
  return {red, green, blue, chromaticity(space.white_xyz())};
}

bool are_the_same(const Chromaticities& a, const Chromaticities& b) {
  // Files have five decimals at most, or a float's digits.
  constexpr double tolerance = 1e-5;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!(std::abs(a[k].x - b[k].x) <= tolerance && std::abs(a[k].y - b[k].y) <= tolerance))
      return false;
  return true;
}

RgbColorSpace space_with(const Chromaticities& c, const std::string& name) try {
  for (const RgbColorSpace& space : built_in_color_spaces())
    if (!space.is_xyz() && (name.empty() || name == space.name()) &&
        are_the_same(c, chromaticities_of(space)))
      return space;
  return {name.empty() ? "custom" : name, {c[0], c[1], c[2]}, xyz_from_chromaticity(c[3])};
} catch (const InputError& error) {
  throw BadImage("the attribute chromaticities: " + error.message());
}

/// What the file tells of its R, G and B.
RgbColorSpace space_in(const Bytes& file) {
  const auto numbers = image_io::exr_chromaticities(file);
  if (!numbers) return lin_rec709_color_space();
  Chromaticities c;
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = {(*numbers)[2 * k], (*numbers)[2 * k + 1]};
  return space_with(c, image_io::exr_text(file, kColorSpaceAttribute).value_or(""));
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

}  // namespace

PictureFile read_picture(const std::filesystem::path& path, std::uint64_t max_bytes) {
  return image_io::read_with(path, max_bytes, picture_from);
}

void write_picture(const std::filesystem::path& path, const Picture& picture,
                   const PictureFileOptions& options) {
  if (picture.channels[0].empty()) throw OutputError(path.string(), "the picture has no pixels");
  if (options.half && !openexr_io::fits_half(picture.channels))
    throw OptionError(
        "half precision holds values up to 65504 and this picture has larger ones; write 32-bit "
        "floating point");
  Imf::Header header =
      openexr_io::rgb_header(picture.width(), picture.height(), picture.color_space, options.half);
  header.insert(kColorSpaceAttribute, Imf::StringAttribute(picture.color_space.name()));
  header.insert("glare:software", Imf::StringAttribute("glare " GLARE_VERSION));
  for (const auto& [name, text] : options.attributes)
    header.insert(name, Imf::StringAttribute(text));
  openexr_io::write_rgb_file(path, header, picture.color_space, picture.channels,
                             {options.half, options.threads, options.keep_going});
}

}  // namespace glare
