// A lamp by its built-in name or from a table in a file.
#pragma once

#include <filesystem>
#include <string>

#include "glare/spectrum/spectrum.h"

namespace glare {

struct NamedLamp {
  std::string name;            ///< As given, or the file's name without its folder.
  std::filesystem::path file;  ///< Empty for a built-in lamp.
  Spectrum spectrum;
};

/// A lamp's table "wavelength_nm, power" (see `parse_lamp_table`). Throws `InputError`.
NamedLamp read_lamp_table(const std::filesystem::path& path);

/// What `name_or_file` means: a built-in name or a black body, else a file. Throws `OptionError`
/// where it is neither and doesn't look like a path, else `InputError`.
NamedLamp lamp_from(const std::string& name_or_file);

}  // namespace glare
