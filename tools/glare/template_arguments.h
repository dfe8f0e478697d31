// What the command line of glare template says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "console.h"
#include "glare/aperture/eye.h"
#include "glare/template/make_template.h"

namespace CLI {
class App;
}

namespace glare::tool {

/// The command line, as given or by default.
struct TemplateArguments {
  std::string output, preview;
  std::string pupil, eyelashes;
  std::optional<double> width_mm;
  double pupil_diameter_mm = EyeParameters{}.pupil.diameter_mm;
  std::uint64_t seed = EyeParameters{}.seed;
  std::vector<std::string> lamps = {"D65"};
  std::string observer = TemplateOptions{}.observer;
  std::vector<double> wavelength_range_nm = {TemplateOptions{}.wavelength_range_nm.lo_nm,
                                             TemplateOptions{}.wavelength_range_nm.hi_nm};
  std::string size = std::to_string(TemplateOptions{}.width);
  double fov_deg = TemplateOptions{}.field_of_view_deg;
  std::string color_space = TemplateOptions{}.color_space.name();
  std::string ocio;
  std::string white = "none", normalize = "peak", gamut = "keep";
  bool half = false;
  int threads = 0;
  std::uint64_t memory_limit_bytes = 0;
  bool quiet = false, verbose = false;

  bool has_images() const { return !pupil.empty() || !eyelashes.empty(); }
  Verbosity verbosity() const {
    return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal;
  }
};

/// Adds the options to the subcommand; `arguments` are set when it is parsed, and outlive it.
void add_template_options(CLI::App& command, TemplateArguments& arguments);

/// Throws `OptionError` where options contradict one another.
void require_consistent(const TemplateArguments& arguments);

/// The library's options, but for the progress. Throws `OptionError` for a value that means
/// nothing, and what `find_color_space` throws.
TemplateOptions template_options(const TemplateArguments& arguments);

/// The user's OpenColorIO config; empty where the colour space is a built-in one.
std::filesystem::path user_color_config(const TemplateArguments& arguments);

}  // namespace glare::tool
