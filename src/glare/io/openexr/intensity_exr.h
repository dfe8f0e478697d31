// Luminous intensities as OpenEXR files. Internal.
#pragma once

#include <filesystem>
#include <functional>

#include "glare/base/image.h"
#include "glare/photometry/intensity_grid.h"

namespace glare::openexr_io {

/// Writes one channel, Y, of 32-bit floats, with the grid's ranges; all or nothing. Throws
/// `OutputError`, and `Cancelled` where `keep_going` says false.
void write_intensities(const std::filesystem::path& path, const Image<float>& candela,
                       const IntensityGrid& grid, const std::function<bool()>& keep_going);

}  // namespace glare::openexr_io
