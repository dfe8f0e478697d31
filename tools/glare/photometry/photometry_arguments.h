// What the commands that read photometric files share.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "glare/photometry/photometric_data.h"

namespace CLI {
class App;
}

namespace glare::tool {

/// A photometric file, and what is told to read it.
struct PhotometryInput {
  std::string file;
  /// Of an image: H of its first and last column, V of its bottom and top row.
  std::optional<std::array<double, 2>> h_deg, v_deg;
  std::optional<double> white_cd;  ///< Of an image.
  std::optional<int> lamp_set;     ///< Of EULUMDAT.
  bool quiet = false;
  std::string range_prefix;  ///< Of the options for an image's degrees, such as "--input-".
};

/// Adds the file and the options to read it; those for an image's degrees are `prefix`h-deg and
/// `prefix`v-deg. The input outlives the command.
void add_photometry_input(CLI::App& command, PhotometryInput& input, const std::string& prefix);

/// Two numbers, ascending, as an option "LO HI".
void add_range_option(CLI::App& command, const std::string& name,
                      std::optional<std::array<double, 2>>& range, const std::string& help);

/// Throws as the library's `read_photometry` does.
PhotometricData photometry_from(const PhotometryInput& input);

/// The file's warnings on the error stream; not when quiet.
void tell_warnings(const PhotometryInput& input, const PhotometricFileInfo& info);

}  // namespace glare::tool
