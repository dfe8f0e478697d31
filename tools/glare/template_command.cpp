// glare template: from an aperture and a lamp to a glare template in a file.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "commands.h"
#include "console.h"
#include "glare/glare.h"
#include "glare/glare_io.h"
#include "interruption.h"
#include "template_arguments.h"
#include "template_recipe.h"

namespace glare::tool {

namespace {

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
  TemplateOptions options = template_options(arguments);
  options.progress = console.progress("glare template");
  const WavelengthRange range = range_of(lamp, options);
  warn_of_missed_light(lamp, options, console);

  const Aperture aperture = aperture_of(arguments, options, range, console);
  options.progress = progress_part(options.progress, kShareOfAperture, 1);
  const std::string recipe_text = recipe(arguments, lamp);
  GlareTemplate glare_template = make_template(aperture, lamp.spectrum, options, lamp.name);
  glare_template.recipe = recipe_text;
  if (arguments.half) warn_of_lost_digits(glare_template, console);
  write_template(arguments.output, glare_template,
                 {arguments.half, arguments.threads, [] { return !interrupted(); }});
  if (!arguments.preview.empty()) write_preview(arguments.preview, glare_template);
  tell_what_was_made(glare_template, aperture, console);
}

}  // namespace

Command add_template_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "template", "Make a glare template, from aperture images or, without, from the built-in eye");
  const auto arguments = std::make_shared<TemplateArguments>();
  add_template_options(command, *arguments);
  return [arguments] { run_template(*arguments); };
}

}  // namespace glare::tool
