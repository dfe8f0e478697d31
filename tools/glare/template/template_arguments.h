// What the command line of glare template says.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "aperture/eye_arguments.h"
#include "console.h"
#include "frames.h"
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
  bool built_in_eye = false;  ///< Asked for by name; it is what there is without images, too.
  EyeArguments eye;
  FrameArguments frames;
  std::string scatter = "none";
  std::optional<double> age_years, pigment;  ///< Not given: those of `Straylight{}`.
  double defocus_dioptre = 0;
  std::string zernike;
  bool chromatic = false;
  double focused_nm = Aberrations{}.focused_nm;
  bool stiles_crawford = false;
  double stiles_crawford_rho_per_mm2 = StilesCrawford{}.rho_per_mm2;
  std::vector<double> stiles_crawford_peak_mm = {0, 0};
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

  /// The built-in eye that the options mean.
  EyeParameters eye_parameters() const { return tool::eye_parameters(eye, age_years); }
  bool has_images() const { return !pupil.empty() || !eyelashes.empty(); }
  Verbosity verbosity() const {
    return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal;
  }
};

/// Adds the options to the subcommand; `arguments` are set when it is parsed, and outlive it.
void add_template_options(CLI::App& command, TemplateArguments& arguments);

/// Adds `--age` and `--pigment` of the eye that scatters.
void add_eye_options(CLI::App& command, std::optional<double>& age_years,
                     std::optional<double>& pigment);

/// The eye they mean; what isn't given is as in `otherwise`. Throws `OptionError`.
Straylight eye_of(const std::optional<double>& age_years, const std::optional<double>& pigment,
                  const Straylight& otherwise = {});

/// Throws `OptionError` where options contradict one another.
void require_consistent(const TemplateArguments& arguments);

/// The library's options, but for the progress. Throws `OptionError` for a value that means
/// nothing, and what `find_color_space` throws.
TemplateOptions template_options(const TemplateArguments& arguments);

/// The user's OpenColorIO config; empty where the colour space is a built-in one.
std::filesystem::path user_color_config(const TemplateArguments& arguments);

}  // namespace glare::tool
