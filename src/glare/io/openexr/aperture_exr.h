// Apertures as OpenEXR files. Internal.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "glare/aperture/aperture.h"

namespace glare::openexr_io {

/// Writes one channel, Y, of 32-bit floats, with `glare:apertureWidth_mm`, `glare:recipe` and
/// `glare:software`; all or nothing. Throws `OutputError`, and `Cancelled` where `keep_going` says
/// false.
void write_aperture(const std::filesystem::path& path, const Aperture& aperture,
                    const std::string& recipe, const std::function<bool()>& keep_going);

}  // namespace glare::openexr_io
