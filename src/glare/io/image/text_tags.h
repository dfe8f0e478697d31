// Texts and numbers beside a picture's pixels, by name. Internal.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "glare/io/image/byte_reader.h"

namespace glare::image_io {

/// What the width of an aperture's picture is called, in mm.
inline constexpr const char* kWidthTag = "glare:apertureWidth_mm";

/// The number that a PNG file's tEXt chunk or an OpenEXR file's float attribute of that name holds;
/// nothing where there is none, or it isn't positive and finite, or the file is of another kind or
/// damaged.
std::optional<double> positive_tag(const Bytes& file, const std::string& name);

/// The text of an OpenEXR file's string attribute of that name; nothing where there is none, or the
/// file is of another kind or damaged.
std::optional<std::string> exr_text(const Bytes& file, const std::string& name);

/// The numbers of an OpenEXR file's attribute chromaticities, x and y of red, green, blue and
/// white; nothing as above.
std::optional<std::array<float, 8>> exr_chromaticities(const Bytes& file);

/// A PNG file with one more text (tEXt, so of Latin-1 characters), before its pixels.
Bytes png_with_text(const Bytes& png, const std::string& name, const std::string& text);

}  // namespace glare::image_io
