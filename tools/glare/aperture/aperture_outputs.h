// What the commands that draw apertures share: resolution, and pictures written with a recipe.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "aperture/eye_arguments.h"
#include "console.h"
#include "glare/aperture/aperture.h"

namespace CLI {
class App;
}

namespace glare::tool {

/// How finely an aperture is drawn, and how much is said.
struct DrawingArguments {
  std::optional<double> pixel_um;
  std::optional<int> size;
  int threads = 0;
  bool quiet = false;

  Verbosity verbosity() const { return quiet ? Verbosity::quiet : Verbosity::normal; }
};

void add_drawing_options(CLI::App& command, DrawingArguments& arguments);

/// The pixel of a picture of that width; of 4 um, where nothing is given. Throws `OptionError`, and
/// `MemoryError` where the picture would take too much.
double pixel_mm(const DrawingArguments& arguments, double width_mm);

/// Throws `OptionError` for a name that doesn't end in .exr or .png or is there twice, and
/// `OutputError` for one that can't be written.
void require_pictures(const std::vector<std::string>& files);

/// The recipe of a picture: the command that makes it again, as JSON of ASCII characters.
std::string aperture_recipe(const std::string& what, const std::vector<OptionText>& options);

}  // namespace glare::tool
