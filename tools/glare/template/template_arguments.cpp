#include "template/template_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <system_error>

#include "common_options.h"
#include "glare/base/error.h"
#include "glare/io/color_config.h"
#include "glare/io/memory.h"
#include "glare/io/zernike_file.h"
#include "glare/spectrum/observer.h"

namespace glare::tool {

namespace {

void require_config(const std::string& ocio) {
  std::error_code ignored;
  if (!ocio.empty() && !ocio.starts_with("ocio://") && !std::filesystem::exists(ocio, ignored))
    throw InputError(ocio, "no such OpenColorIO config");
}

/// What a preview takes while it is made: its pixels, its samples, and the file in memory.
std::uint64_t preview_bytes(const TemplateOptions& options) {
  constexpr std::uint64_t kPixelBytes = 3 * (sizeof(float) + 1 + 1);
  return kPixelBytes * static_cast<std::uint64_t>(options.width) *
         static_cast<std::uint64_t>(options.height);
}

void add_aperture_options(CLI::App& command, TemplateArguments& a) {
  auto* const pupil =
      command.add_option("--pupil", a.pupil, "Transmittance image of the pupil, white = open")
          ->check(not_empty());
  auto* const eyelashes = command
                              .add_option("--eyelashes", a.eyelashes,
                                          "Transmittance image of the eyelashes, white = open")
                              ->check(not_empty());
  command.add_option(
      "--width-mm", a.width_mm,
      "Physical width of the aperture images (default: what the files tell, as those "
      "of glare aperture do)");
  auto* const eye = command.add_flag("--eye", a.built_in_eye,
                                     "The built-in eye: the default where no images are given");
  std::vector<CLI::Option*> of_eye = add_eye_model_options(command, a.eye);
  of_eye.push_back(eye);
  of_eye.push_back(add_frame_options(command, a.frames));
  for (auto* const option : of_eye) option->excludes(pupil)->excludes(eyelashes);
}

void add_scatter_options(CLI::App& command, TemplateArguments& a) {
  command
      .add_option("--scatter", a.scatter,
                  "Add what the eye's media scatter; cie: after CIE 146:2002, the general equation")
      ->check(CLI::IsMember({"none", "cie"}))
      ->capture_default_str();
  add_eye_options(command, a.age_years, a.pigment);
}

void add_optics_options(CLI::App& command, TemplateArguments& a) {
  const std::string group = "Optics of the eye";
  command
      .add_option("--defocus-d", a.defocus_dioptre,
                  "Refractive error in dioptres, negative: short-sighted")
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--zernike", a.zernike,
                  "CSV file of pupil_diameter_mm,D and rows of j,coefficient_um (OSA/ANSI)")
      ->check(not_empty())
      ->group(group);
  auto* const chromatic =
      command
          .add_flag("--chromatic-aberration", a.chromatic,
                    "Longitudinal chromatic aberration of the chromatic eye (Thibos 1992)")
          ->group(group);
  command.add_option("--focused-nm", a.focused_nm, "Wavelength at which that is 0")
      ->capture_default_str()
      ->needs(chromatic)
      ->group(group);
  auto* const effect = command
                           .add_flag("--stiles-crawford", a.stiles_crawford,
                                     "Light counts 10^(-rho r^2) as much off the peak")
                           ->group(group);
  command
      .add_option("--stiles-crawford-rho-per-mm2", a.stiles_crawford_rho_per_mm2, "Its rho, 0 to 1")
      ->capture_default_str()
      ->needs(effect)
      ->group(group);
  command
      .add_option("--stiles-crawford-peak-mm", a.stiles_crawford_peak_mm,
                  "Its peak, right and up from the picture's middle")
      ->expected(2)
      ->type_name("X Y")
      ->capture_default_str()
      ->needs(effect)
      ->group(group);
}

Aberrations aberrations(const TemplateArguments& a) {
  Aberrations result;
  const EyeParameters eye = a.has_images() ? EyeParameters{} : a.eye_parameters();
  if (!a.has_images())
    result.pupil_center = {eye.pupil.decentring_x_mm, -eye.pupil.decentring_y_mm};
  result.defocus_dioptre = a.defocus_dioptre;
  if (!a.zernike.empty()) result.zernike = read_zernike_file(a.zernike);
  result.chromatic = a.chromatic;
  result.focused_nm = a.focused_nm;
  if (a.stiles_crawford)
    result.stiles_crawford =
        StilesCrawford{a.stiles_crawford_rho_per_mm2,
                       {a.stiles_crawford_peak_mm[0], a.stiles_crawford_peak_mm[1]}};
  require_valid(result);
  return result;
}

void add_light_options(CLI::App& command, TemplateArguments& a) {
  command
      .add_option("--lamp", a.lamps,
                  "Name (see glare lamps), blackbody:KELVIN, or CSV file of wavelength_nm,power; "
                  "may be given several times, for a template of each")
      ->allow_extra_args(false)
      ->type_name("TEXT")
      ->default_str(a.lamps.front());
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
  command
      .add_option("-o,--output", a.output,
                  "OpenEXR file to write; {lamp} in it stands for the lamp's name (a CSV file's "
                  "without folder and ending), and several lamps need it")
      ->required()
      ->check(not_empty());
  command.add_option("--preview", a.preview, "Tone-mapped PNG to write too; {lamp} as in --output")
      ->check(not_empty());
  command.add_flag("--half", a.half, "16-bit instead of 32-bit floating point");
  add_threads_option(command, a.threads);
  add_memory_limit_option(command, a.memory_limit_bytes);
  add_verbosity_options(command, a.quiet, a.verbose);
}

}  // namespace

void add_template_options(CLI::App& command, TemplateArguments& arguments) {
  add_output_options(command, arguments);
  add_aperture_options(command, arguments);
  add_scatter_options(command, arguments);
  add_optics_options(command, arguments);
  add_light_options(command, arguments);
  add_picture_options(command, arguments);
}

void add_eye_options(CLI::App& command, std::optional<double>& age_years,
                     std::optional<double>& pigment) {
  const Straylight usual;
  command.add_option("--age", age_years, "The eye's age in years, 0 to 100, for what scatters")
      ->check(not_empty())
      ->default_str(CLI::detail::to_string(usual.age_years));
  command
      .add_option("--pigment", pigment,
                  "The scattering eye's pigment: 0 very dark, 0.5 brown, 1 blue-green, 1.2 light "
                  "blue")
      ->check(not_empty())
      ->default_str(CLI::detail::to_string(usual.pigment));
}

Straylight eye_of(const std::optional<double>& age_years, const std::optional<double>& pigment,
                  const Straylight& otherwise) {
  const Straylight eye{age_years.value_or(otherwise.age_years),
                       pigment.value_or(otherwise.pigment)};
  require_valid(eye);
  return eye;
}

void require_consistent(const TemplateArguments& arguments) {
  if (arguments.scatter == "none" && arguments.pigment)
    throw OptionError("--pigment goes with --scatter cie");
  if (arguments.scatter == "none" && arguments.age_years && !arguments.eye.adapting_luminance_cd_m2)
    throw OptionError("--age goes with --scatter cie or --adapting-luminance-cd-m2");
  if (!arguments.has_images() && arguments.width_mm)
    throw OptionError("--width-mm goes with --pupil or --eyelashes");
}

TemplateOptions template_options(const TemplateArguments& arguments) {
  require_config(arguments.ocio);
  TemplateOptions options;
  const auto size = size_px_from(arguments.size);
  options.width = size[0];
  options.height = size[1];
  options.field_of_view_deg = arguments.fov_deg;
  options.aberrations = aberrations(arguments);
  options.observer = arguments.observer;
  options.wavelength_range_nm = {arguments.wavelength_range_nm[0],
                                 arguments.wavelength_range_nm[1]};
  options.color_space = find_color_space(arguments.color_space, user_color_config(arguments));
  if (arguments.scatter == "cie") options.scatter = eye_of(arguments.age_years, arguments.pigment);
  options.white = arguments.white == "lamp" ? WhiteAdaptation::lamp : WhiteAdaptation::none;
  options.gamut = arguments.gamut == "desaturate" ? GamutMapping::desaturate : GamutMapping::keep;
  options.normalization = normalization_from(arguments.normalize);
  options.threads = arguments.threads;
  options.memory_limit_bytes = arguments.memory_limit_bytes != 0 ? arguments.memory_limit_bytes
                                                                 : default_memory_limit_bytes();
  if (!arguments.preview.empty()) options.further_bytes = preview_bytes(options);
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
