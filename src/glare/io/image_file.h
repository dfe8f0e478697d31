// Pictures in files: transmittances read from any of the usual formats, PNG bytes made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glare/base/image.h"

namespace glare {

struct TransmittanceImage {
  Image<float> transmittance;  ///< Each value in [0, 1].
  /// The physical width that the file tells, as those of `write_aperture` do.
  std::optional<double> width_mm = {};
  std::vector<std::string> warnings;  ///< One line each, without the file's name.
};

/// The picture in the file at `path` as transmittances. What kind of picture it is, is told by its
/// content, never by its name: PNG, JPEG, TIFF, OpenEXR, PNM (PBM, PGM, PPM, PFM), BMP or Radiance
/// HDR.
///
/// Values are used as stored: 8-bit 255 and 16-bit 65535 are 1 (in PNM: the file's maximum), floats
/// are themselves. No transfer curve is decoded, no colour profile applied, no alpha divided out; a
/// palette is looked up. One channel is taken as it is; of three, the luminance 0.2126 R + 0.7152 G
/// + 0.0722 B. Alpha is ignored, with a warning, unless the other channels are constant and alpha
/// is not: then alpha is the transmittance. Metadata are not looked at, an orientation among them:
/// the first stored row is the top. Of several pictures in a file, the first is read.
///
/// OpenEXR channels go by their names: R, G, B (and A), or Y (and A), or a single channel of any
/// name; further ones are ignored with a warning. The picture is the display window; what of it
/// lies outside the data window is 0, opaque.
///
/// Values up to 1.001 are limited to 1. Throws `InputError`, whose place is `path`, where the file
/// can't be read, is none of these formats, uses a part of one that Glare does not read (CMYK,
/// JPEG or fax compression in TIFF, deep or subsampled OpenEXR, ...), is damaged or cut short, has
/// a side above 65535 pixels, or has a value that is not finite, negative, or above 1.001. Throws
/// `MemoryError`, before it allocates, where reading would take more than `max_bytes` of memory,
/// and `Error` where the module glare_image_codec can't be loaded; so do the two functions below.
TransmittanceImage read_transmittance(const std::filesystem::path& path, std::uint64_t max_bytes);

/// An 8-bit RGB PNG file, tagged sRGB, of a picture that is already encoded for a display: each
/// value in [0, 1], others are limited to it, NaN is 0. An ordered 8 x 8 dither of less than one
/// step hides the steps in slow gradients; a multiple of 1/255 is kept exactly. The same picture
/// gives the same bytes. Throws `OutputError` for a picture without pixels.
std::vector<std::byte> encode_png_rgb8(const Image<std::array<float, 3>>& display_rgb);

/// The same with 16 bits, rounded to multiples of 1/65535 without a dither.
std::vector<std::byte> encode_png_rgb16(const Image<std::array<float, 3>>& display_rgb);

/// A 16-bit grey PNG file of values in [0, 1] (others are limited to it, NaN is 0), rounded to
/// multiples of 1/65535; it carries no transfer curve. `read_transmittance` gives them back. Throws
/// `OutputError` for a picture without pixels.
std::vector<std::byte> encode_png_gray16(const Image<float>& values);

/// An 8-bit grey PNG file of a mask, without a transfer curve. Throws `OutputError` for a picture
/// without pixels.
std::vector<std::byte> encode_png_gray8(const Image<std::uint8_t>& values);

}  // namespace glare
