// Apertures from pictures, and to pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glare/aperture/aperture.h"

namespace glare {

struct ApertureFiles {
  std::filesystem::path pupil;      ///< Transmittance, white = open; empty: none.
  std::filesystem::path eyelashes;  ///< The same; at least one of the two is given.
  /// Physical width of the pictures, 0.001 to 1e6; nothing: what the files tell, as those of
  /// `write_aperture` do.
  std::optional<double> width_mm = {};
  std::uint64_t memory_limit_bytes = UINT64_MAX;
};

struct ApertureRead {
  Aperture aperture;
  std::vector<std::string> warnings;  ///< For a person, one line each.
};

/// The aperture that one or two transmittance pictures make together, on the finer grid. See
/// `read_transmittance` for what pictures may be and `stacked` for how two are brought together.
/// Throws `InputError`, also where two files tell different widths, `OptionError` for a width
/// outside its range or where none is given and none is told, `MemoryError`.
ApertureRead read_aperture(const ApertureFiles& files);

/// The PNG file that `write_aperture` writes.
std::vector<std::byte> encode_aperture_png(const Aperture& aperture, const std::string& recipe);

/// Writes an aperture's picture, all or nothing: OpenEXR (one channel of 32-bit floats) where the
/// name ends in .exr, 16-bit grey PNG where it ends in .png. Attributes of the OpenEXR file, texts
/// of the PNG file: `glare:apertureWidth_mm`, `glare:recipe` (the text `recipe`, of ASCII
/// characters) and `glare:software`. The same aperture gives the same bytes. Throws `OptionError`
/// for another ending or a band-limited aperture, `OutputError`, and `Cancelled` where
/// `keep_going`, if not empty, says false.
void write_aperture(const std::filesystem::path& path, const Aperture& aperture,
                    const std::string& recipe, const std::function<bool()>& keep_going = {});

}  // namespace glare
