// glare template: from an aperture and a lamp to a glare template in a file.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "console.h"
#include "glare/glare.h"
#include "glare/glare_io.h"
#include "interruption.h"
#include "template_recipe.h"

namespace glare::tool {

namespace {

/// The command line, as given or by default.
struct TemplateArguments {
  std::string output, preview;
  std::string pupil, eyelashes;
  std::optional<double> width_mm;
  double pupil_diameter_mm = 6.5;
  std::uint64_t seed = 1;
  std::string lamp = "D65";
  std::string observer = "cie1931-2deg";
  std::vector<double> wavelength_range_nm = {380, 780};
  std::string size = "512";
  double fov_deg = 5;
  std::string color_space = "lin_rec709";
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

/// A number in as few digits as give it back.
std::string text_of(double number) {
  char text[40];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    if (std::strtod(text, nullptr) == number) break;
  }
  return text;
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end || text.empty()) return std::nullopt;
  return number;
}

/// "512" or "640x480".
void set_size(const std::string& text, TemplateOptions& options) {
  const auto cross = text.find('x');
  const auto width = whole_number(text.substr(0, cross));
  const auto height = cross == std::string::npos ? width : whole_number(text.substr(cross + 1));
  constexpr std::uint64_t kLargest = 65535;
  if (!width || !height || *width < 1 || *height < 1 || *width > kLargest || *height > kLargest)
    throw OptionError("--size " + text + ": expected N or WxH, in pixels from 1 to 65535");
  options.width = static_cast<int>(*width);
  options.height = static_cast<int>(*height);
}

/// A file of one kind isn't given the ending of another.
void require_no_other_ending(const std::string& path, const std::string& ending,
                             const std::string& option) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (extension == ending) return;
  for (const char* other :
       {".exr", ".png", ".jpg", ".jpeg", ".tif", ".tiff", ".hdr", ".bmp", ".csv"})
    if (extension == other)
      throw OptionError(option + " " + path + ": expected a name that ends in " + ending);
}

/// The user's config, where the colour space isn't a built-in one.
std::filesystem::path user_color_config(const TemplateArguments& arguments) {
  const auto built_in = built_in_color_space_names();
  if (std::find(built_in.begin(), built_in.end(), arguments.color_space) != built_in.end())
    return {};
  return arguments.ocio.empty() ? color_config_from_environment()
                                : std::filesystem::path(arguments.ocio);
}

void require_config(const std::string& ocio) {
  std::error_code ignored;
  if (!ocio.empty() && !ocio.starts_with("ocio://") && !std::filesystem::exists(ocio, ignored))
    throw InputError(ocio, "no such OpenColorIO config");
}

TemplateOptions template_options(const TemplateArguments& arguments, const Console& console) {
  require_config(arguments.ocio);
  TemplateOptions options;
  set_size(arguments.size, options);
  options.field_of_view_deg = arguments.fov_deg;
  options.observer = arguments.observer;
  options.wavelength_range_nm = {arguments.wavelength_range_nm[0],
                                 arguments.wavelength_range_nm[1]};
  options.color_space = find_color_space(arguments.color_space, user_color_config(arguments));
  options.white = arguments.white == "lamp" ? WhiteAdaptation::lamp : WhiteAdaptation::none;
  options.gamut = arguments.gamut == "desaturate" ? GamutMapping::desaturate : GamutMapping::keep;
  options.normalization = normalization_from(arguments.normalize);
  options.threads = arguments.threads;
  options.memory_limit_bytes = arguments.memory_limit_bytes != 0 ? arguments.memory_limit_bytes
                                                                 : memory_size_bytes() / 4 * 3;
  options.progress = console.progress("glare template");
  return options;
}

/// The share of the work, as the progress bar counts it, that goes before the template's own.
constexpr double kShareOfAperture = 0.05;

Aperture aperture_of(const TemplateArguments& arguments, const TemplateOptions& options,
                     const WavelengthRange& range, const Console& console) {
  if (!arguments.has_images()) {
    EyeParameters eye;
    eye.pupil_diameter_mm = arguments.pupil_diameter_mm;
    eye.seed = arguments.seed;
    TemplateOptions part = options;
    part.progress = progress_part(options.progress, 0, kShareOfAperture);
    return draw_template_eye(eye, part, range);
  }
  ApertureRead read = read_aperture(
      {arguments.pupil, arguments.eyelashes, *arguments.width_mm, options.memory_limit_bytes});
  for (const std::string& warning : read.warnings) console.warn(warning);
  return std::move(read.aperture);
}

/// The wavelengths integrated over; an error names the lamp as it was given.
WavelengthRange range_of(const NamedLamp& lamp, const TemplateOptions& options) {
  try {
    return effective_range(lamp.spectrum, options);
  } catch (const InputError& error) {
    throw InputError(lamp.file.empty() ? "lamp " + lamp.name : lamp.file.string(), error.message());
  }
}

void warn_of_missed_light(const NamedLamp& lamp, const TemplateOptions& options,
                          const Console& console) {
  constexpr double kMuch = 0.01;
  const double missed = share_of_sensitivity_missed(
      lamp.spectrum, color_matching_functions(options.observer), options.wavelength_range_nm);
  if (missed <= kMuch) return;
  const WavelengthRange covered = lamp.spectrum.range();
  char text[120];
  std::snprintf(text, sizeof text,
                "%g to %g nm, misses %.1f %% of what the observer sees (by luminous efficiency)",
                covered.lo_nm, covered.hi_nm, 100 * missed);
  console.warn("lamp " + lamp.name + ": its table, " + text);
}

/// Half precision has full digits down to 6.1e-5; a template's outskirts are often darker.
void warn_of_lost_digits(const GlareTemplate& glare_template, const Console& console) {
  constexpr double kSmallestNormal = 6.1e-5;
  std::size_t dark = 0;
  const int width = glare_template.width(), height = glare_template.height();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) dark += glare_template.luminance(x, y) < kSmallestNormal;
  const double share = static_cast<double>(dark) / (static_cast<double>(width) * height);
  if (share < 0.01) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "--half: %.0f %% of the pixels are darker than 6.1e-5, where half precision loses "
                "digits and then the light itself",
                100 * share);
  console.warn(text);
}

std::vector<RecipeOption> recipe_options(const TemplateArguments& a, const NamedLamp& lamp) {
  std::vector<RecipeOption> options;
  const auto add_file = [&](const char* name, const std::filesystem::path& file) {
    if (!file.empty()) options.push_back({name, {file.filename().string()}, file});
  };
  add_file("--pupil", a.pupil);
  add_file("--eyelashes", a.eyelashes);
  if (a.has_images()) {
    options.push_back({"--width-mm", {text_of(*a.width_mm)}, {}});
  } else {
    options.push_back({"--pupil-mm", {text_of(a.pupil_diameter_mm)}, {}});
    options.push_back({"--seed", {std::to_string(a.seed)}, {}});
  }
  // A file that is named like a built-in lamp is told from it by its folder.
  const bool ambiguous = !lamp.file.empty() && find_lamp(lamp.name).has_value();
  options.push_back({"--lamp", {(ambiguous ? "./" : "") + lamp.name}, lamp.file});
  options.push_back({"--observer", {a.observer}, {}});
  options.push_back({"--wavelength-range-nm",
                     {text_of(a.wavelength_range_nm[0]), text_of(a.wavelength_range_nm[1])},
                     {}});
  options.push_back({"--size", {a.size}, {}});
  options.push_back({"--fov-deg", {text_of(a.fov_deg)}, {}});
  options.push_back({"--colorspace", {a.color_space}, {}});
  const std::filesystem::path config = user_color_config(a);
  std::error_code ignored;
  if (std::filesystem::is_regular_file(config, ignored))
    add_file("--ocio", config);
  else if (!config.empty())  // A name such as ocio://default.
    options.push_back({"--ocio", {config.string()}, {}});
  options.push_back({"--white", {a.white}, {}});
  options.push_back({"--normalize", {a.normalize}, {}});
  options.push_back({"--gamut", {a.gamut}, {}});
  if (a.half) options.push_back({"--half", {}, {}});
  return options;
}

bool same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code ignored;
  return std::filesystem::weakly_canonical(a, ignored) ==
         std::filesystem::weakly_canonical(b, ignored);
}

void require_different_files(const TemplateArguments& a) {
  if (same_file(a.output, a.preview))
    throw OptionError("--output and --preview name the same file, " + a.output);
  for (const std::string& output : {a.output, a.preview})
    for (const std::string& input : {a.pupil, a.eyelashes, a.lamp, a.ocio})
      if (same_file(output, input)) throw OptionError("the output " + output + " is an input too");
}

void require_consistent(const TemplateArguments& arguments) {
  require_different_files(arguments);
  require_writable(arguments.output);
  if (!arguments.preview.empty()) require_writable(arguments.preview);
  require_no_other_ending(arguments.output, ".exr", "--output");
  if (!arguments.preview.empty()) require_no_other_ending(arguments.preview, ".png", "--preview");
  if (arguments.has_images() && !arguments.width_mm)
    throw OptionError("--width-mm is missing: the physical width of the aperture images");
  if (!arguments.has_images() && arguments.width_mm)
    throw OptionError("--width-mm goes with --pupil or --eyelashes");
}

void write_preview(const std::string& path, const GlareTemplate& glare_template) {
  write_file_atomically(path, encode_png_rgb8(preview(glare_template)),
                        [] { return !interrupted(); });
}

void tell_what_was_made(const GlareTemplate& t, const Aperture& aperture, const Console& console) {
  char text[240];
  std::snprintf(text, sizeof text,
                "aperture %d x %d samples of %.4g um, template %d x %d pixels of %.4g degrees, "
                "%.4g %% of the light, 1 is %.6g per steradian",
                aperture.transmittance.width(), aperture.transmittance.height(),
                aperture.pixel_mm() * 1e3, t.width(), t.height(), t.pixel_pitch_deg(),
                100 * t.captured_energy, t.per_steradian);
  console.tell(text);
}

void run_template(const TemplateArguments& arguments) {
  const Console console(arguments.verbosity());
  require_consistent(arguments);
  const NamedLamp lamp = lamp_from(arguments.lamp);
  TemplateOptions options = template_options(arguments, console);
  const WavelengthRange range = range_of(lamp, options);
  warn_of_missed_light(lamp, options, console);

  const Aperture aperture = aperture_of(arguments, options, range, console);
  options.progress = progress_part(options.progress, kShareOfAperture, 1);
  const std::string recipe_text = recipe(recipe_options(arguments, lamp));
  GlareTemplate glare_template = make_template(aperture, lamp.spectrum, options, lamp.name);
  glare_template.recipe = recipe_text;
  if (arguments.half) warn_of_lost_digits(glare_template, console);
  write_template(arguments.output, glare_template,
                 {arguments.half, arguments.threads, [] { return !interrupted(); }});
  if (!arguments.preview.empty()) write_preview(arguments.preview, glare_template);
  tell_what_was_made(glare_template, aperture, console);
}

/// For options that name something.
CLI::Validator not_empty() {
  return CLI::Validator([](std::string& text) { return text.empty() ? "is empty" : ""; }, "");
}

/// For whole numbers, which CLI11 would let wrap around.
CLI::Validator whole() {
  return CLI::Validator(
      [](std::string& text) {
        return whole_number(text) ? "" : "'" + text + "' isn't a whole number";
      },
      "");
}

/// After AsSizeValue, which lets negative and too large numbers wrap around.
CLI::Validator plausible_bytes() {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 60;
  return CLI::Validator(
      [](std::string& text) {
        const auto bytes = whole_number(text);
        return bytes && *bytes > 0 && *bytes < kMost ? "" : "isn't an amount of memory";
      },
      "");
}

void add_aperture_options(CLI::App& command, TemplateArguments& a) {
  auto* const pupil =
      command.add_option("--pupil", a.pupil, "Transmittance image of the pupil, white = open")
          ->check(not_empty());
  auto* const eyelashes = command
                              .add_option("--eyelashes", a.eyelashes,
                                          "Transmittance image of the eyelashes, white = open")
                              ->check(not_empty());
  command.add_option("--width-mm", a.width_mm, "Physical width of the aperture images");
  auto* const diameter =
      command.add_option("--pupil-mm", a.pupil_diameter_mm, "Built-in eye: diameter of the pupil");
  auto* const seed =
      command.add_option("--seed", a.seed, "Built-in eye: which eyelashes")->check(whole());
  for (auto* const option : {diameter, seed}) {
    option->capture_default_str()->excludes(pupil)->excludes(eyelashes);
  }
}

void add_light_options(CLI::App& command, TemplateArguments& a) {
  command
      .add_option("--lamp", a.lamp,
                  "Name (see glare lamps), blackbody:KELVIN, or CSV file of wavelength_nm,power")
      ->capture_default_str();
  command.add_option("--observer", a.observer, "CIE standard observer")
      ->check(CLI::IsMember(observer_names()))
      ->capture_default_str();
  command.add_option("--wavelength-range-nm", a.wavelength_range_nm, "Shortest and longest")
      ->expected(2)
      ->type_name("LO HI")
      ->capture_default_str();
}

void add_picture_options(CLI::App& command, TemplateArguments& a) {
  command.add_option("--size", a.size, "Pixels: N or WxH")->capture_default_str();
  command.add_option("--fov-deg", a.fov_deg, "Field of view across the width")
      ->capture_default_str();
  command
      .add_option("--colorspace", a.color_space,
                  "xyz, lin_rec709, lin_rec2020, lin_p3d65, acescg, aces2065-1, ntsc1953, or a "
                  "scene-linear space of an OpenColorIO config")
      ->capture_default_str();
  command.add_option("--ocio", a.ocio, "OpenColorIO config (default: $OCIO)")->check(not_empty());
  command.add_option("--white", a.white, "none, or lamp: adapt (Bradford) so that it is white")
      ->check(CLI::IsMember({"none", "lamp"}))
      ->capture_default_str();
  command
      .add_option("--normalize", a.normalize,
                  "peak: brightest pixel 1; energy: sum 1; absolute: per steradian")
      ->check(CLI::IsMember({"peak", "energy", "absolute"}))
      ->capture_default_str();
  command.add_option("--gamut", a.gamut, "keep, or desaturate colours outside the RGB gamut")
      ->check(CLI::IsMember({"keep", "desaturate"}))
      ->capture_default_str();
}

void add_output_options(CLI::App& command, TemplateArguments& a) {
  command.add_option("-o,--output", a.output, "OpenEXR file to write")
      ->required()
      ->check(not_empty());
  command.add_option("--preview", a.preview, "Tone-mapped PNG to write too")->check(not_empty());
  command.add_flag("--half", a.half, "16-bit instead of 32-bit floating point");
  command.add_option("--threads", a.threads, "0: as many as the machine has")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command
      .add_option("--memory-limit", a.memory_limit_bytes,
                  "Such as 4GB (default: three quarters of the machine's)")
      ->transform(CLI::AsSizeValue(false))
      ->check(plausible_bytes());
  auto* const quiet = command.add_flag("--quiet", a.quiet, "No warnings, no progress bar");
  command.add_flag("--verbose", a.verbose, "Say what was made")->excludes(quiet);
}

}  // namespace

Command add_template_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "template", "Make a glare template, from aperture images or, without, from the built-in eye");
  const auto arguments = std::make_shared<TemplateArguments>();
  add_output_options(command, *arguments);
  add_aperture_options(command, *arguments);
  add_light_options(command, *arguments);
  add_picture_options(command, *arguments);
  return [arguments] { run_template(*arguments); };
}

}  // namespace glare::tool
