// Apertures from pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glare/aperture/aperture.h"

namespace glare {

struct ApertureFiles {
  std::filesystem::path pupil;      ///< Transmittance, white = open; empty: none.
  std::filesystem::path eyelashes;  ///< The same; at least one of the two is given.
  double width_mm = 0;              ///< Physical width of the pictures, 0.001 to 1e6.
  std::uint64_t memory_limit_bytes = UINT64_MAX;
};

struct ApertureRead {
  Aperture aperture;
  std::vector<std::string> warnings;  ///< For a person, one line each.
};

/// The aperture that one or two transmittance pictures make together, on the finer grid. See
/// `read_transmittance` for what pictures may be and `stacked` for how two are brought together.
/// Throws `InputError`, `OptionError` for a width outside its range, `MemoryError`.
ApertureRead read_aperture(const ApertureFiles& files);

}  // namespace glare
