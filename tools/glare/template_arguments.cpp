#include "template_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <system_error>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/color_config.h"
#include "glare/io/memory.h"
#include "glare/spectrum/observer.h"

namespace glare::tool {

namespace {

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

void require_config(const std::string& ocio) {
  std::error_code ignored;
  if (!ocio.empty() && !ocio.starts_with("ocio://") && !std::filesystem::exists(ocio, ignored))
    throw InputError(ocio, "no such OpenColorIO config");
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

void add_template_options(CLI::App& command, TemplateArguments& arguments) {
  add_output_options(command, arguments);
  add_aperture_options(command, arguments);
  add_light_options(command, arguments);
  add_picture_options(command, arguments);
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

TemplateOptions template_options(const TemplateArguments& arguments) {
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
  return options;
}

std::filesystem::path user_color_config(const TemplateArguments& arguments) {
  const auto built_in = built_in_color_space_names();
  if (std::find(built_in.begin(), built_in.end(), arguments.color_space) != built_in.end())
    return {};
  return arguments.ocio.empty() ? color_config_from_environment()
                                : std::filesystem::path(arguments.ocio);
}

}  // namespace glare::tool
