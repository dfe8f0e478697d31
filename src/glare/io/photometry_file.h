// Luminous intensity distributions in files: LM-63, EULUMDAT, images.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "glare/photometry/intensity_grid.h"
#include "glare/photometry/photometric_data.h"

namespace glare {

struct ReadPhotometryOptions {
  /// Of an image: H of the centres of its first and last column, V of those of its bottom and top
  /// row, in degrees; as `write_intensity_image` does, images may tell these themselves.
  std::optional<std::array<double, 2>> image_h_deg = {}, image_v_deg = {};
  /// Of an image: the candela of the value 1. Without it values are candela themselves. Pictures of
  /// whole numbers have their white at 1, so they need it: 65535 for 16-bit ones that hold candela.
  std::optional<double> image_white_cd = {};
  std::optional<int> lamp_set = {};  ///< Of EULUMDAT, from 1; nothing: the first.
  std::uint64_t memory_limit_bytes = UINT64_MAX;
};

/// The distribution in a file of any kind, told by its content: IES LM-63 has a line TILT=,
/// EULUMDAT numbers where it has them, images begin as such. The name's ending, .ies or .ldt,
/// decides only where the content leaves it open, and whose errors are told. See `parse_ies` and
/// `parse_eulumdat`. A tilt file is looked for under its name in the file's own folder; a name with
/// a folder in it isn't followed. Texts have at most 64 MB.
///
/// Images are type A, of one channel (or OpenEXR's Y; alpha is ignored, with a warning): columns
/// from the smallest H at the left, rows from the largest V at the top, values as
/// `read_transmittance` takes them but without a limit.
///
/// Throws `InputError`, with path and line, where the file can't be read, is none of these, or is
/// damaged; also for an image that is nowhere above 1 without `image_white_cd`, unless it tells its
/// degrees. Throws `OptionError` for an image without ranges, for ranges or a white outside their
/// limits or for a file that is no image, and for a set of lamps that isn't there; `MemoryError`.
PhotometricData read_photometry(const std::filesystem::path& path,
                                const ReadPhotometryOptions& options = {});

/// Writes the distribution, mounted so, as an image on the grid: OpenEXR, one channel Y of 32-bit
/// floats in candela, the first row at the largest V; with `glare:horizontalRange_deg` and
/// `glare:verticalRange_deg` (V2d), which `read_photometry` takes from there, and
/// `glare:software`. All or nothing; the same bytes for the same distribution. Throws `OptionError`
/// as `require_intensity_grid`, `OutputError`, and `Cancelled` where `progress` says stop.
void write_intensity_image(const std::filesystem::path& path,
                           const LuminousIntensityDistribution& distribution,
                           const IntensityGrid& grid, const Mounting& mounting = {},
                           int threads = 0, const ProgressCallback& progress = {});

}  // namespace glare
