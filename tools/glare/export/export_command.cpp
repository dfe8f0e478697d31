// glare export: a template's kernel as a picture that another program convolves with.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "common_options.h"
#include "console.h"
#include "export/program_settings.h"
#include "file_names.h"
#include "glare/base/units.h"
#include "glare/glare.h"
#include "glare/glare_io.h"
#include "interruption.h"

namespace glare::tool {

namespace {

constexpr int kLargestSize = 8192;

struct ExportArguments {
  std::string input, output, program;
  std::optional<double> fov_deg, pixel_deg;
  bool perspective = false;
  int picture_width = 1920;
  int size = 0;
  double roll_off = 0.25;
  std::string color_space = "lin_rec709", ocio;
  int threads = 0;
  bool quiet = false, verbose = false;

  Verbosity verbosity() const {
    return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal;
  }
};

RgbColorSpace color_space_of(const ExportArguments& a) {
  const std::filesystem::path config =
      a.ocio.empty() ? color_config_from_environment() : std::filesystem::path(a.ocio);
  const RgbColorSpace space = find_color_space(a.color_space, config);
  if (space.is_xyz())
    throw OptionError("--colorspace " + a.color_space +
                      ": expected a space of R, G and B, which is what other programs convolve");
  return space;
}

PixelScale scale_of(const ExportArguments& a, const GlareTemplate& t) {
  if (a.fov_deg)
    return a.perspective ? scale_of_perspective(*a.fov_deg, a.picture_width)
                         : scale_of_field_of_view(*a.fov_deg, a.picture_width);
  return {a.pixel_deg ? *a.pixel_deg * kRadPerDeg : t.pixel_pitch_rad, 1};
}

/// "40 degrees across", "90 degrees across, perspective".
std::string field_of_view_of(const ExportArguments& a, const PixelScale& scale) {
  char text[60];
  std::snprintf(text, sizeof text, "%.6g degrees across%s",
                a.fov_deg.value_or(a.picture_width * scale.pitch_rad / kRadPerDeg),
                a.perspective ? ", perspective" : "");
  return text;
}

KernelImage image_of(const ExportArguments& a, const GlareTemplate& t, const PixelScale& scale) {
  KernelImageOptions options = kernel_program(a.program).options;
  options.size_px = a.size;
  options.roll_off_share = a.roll_off;
  const double extent = std::max(t.width(), t.height()) * t.pixel_pitch_rad / scale.pitch_rad;
  if (a.size == 0 && extent > kLargestSize)
    throw OptionError("the kernel would have " + std::to_string(std::lround(extent)) +
                      " pixels; expected up to " + std::to_string(kLargestSize) +
                      ": larger pixels, or --size");
  PixelKernelOptions kernel_options;
  kernel_options.reach_x_px = kernel_options.reach_y_px =
      a.size == 0 ? 0 : std::clamp(a.size / 2 + 1, 1, kLargestSize);
  return kernel_image(pixel_kernel(t, scale, color_space_of(a), kernel_options), options);
}

std::string text_of(const char* pattern, double value) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

void write(const ExportArguments& a, const ExportedKernel& kernel, const GlareTemplate& t) {
  const KernelImage& image = kernel.image;
  PictureFileOptions options;
  options.half = kernel_program(a.program).options.half;
  options.threads = a.threads;
  options.keep_going = [] { return !interrupted(); };
  options.attributes = {{"glare:kernelFor", a.program},
                        {"glare:kernelCenter_px", std::to_string(image.center_px[0]) + " " +
                                                      std::to_string(image.center_px[1])},
                        {"glare:kernelPixel_deg", text_of("%.9g", kernel.pixel_deg)},
                        {"glare:kernelSum", text_of("%g", image.sum)},
                        {"glare:kernelRollOff", text_of("%g", a.roll_off)},
                        {"glare:recipe", t.recipe}};
  const PictureLayer layer = {"", &image.picture, image.alpha.empty() ? nullptr : &image.alpha};
  write_picture_layers(a.output, {&layer, 1}, options);
}

void run_export(const ExportArguments& a) {
  if (ending_of(a.output) != ".exr")
    throw OptionError("--output " + a.output + ": expected a name that ends in .exr");
  if (same_file(a.output, a.input))
    throw OptionError("the output " + a.output + " is an input too");
  require_writable(a.output);
  const Console console(a.verbosity());
  const GlareTemplate t = read_template(a.input, {default_memory_limit_bytes()});
  const PixelScale scale = scale_of(a, t);
  ExportedKernel kernel = {
      a.output,        image_of(a, t, scale),      scale.pitch_rad / kRadPerDeg,
      a.picture_width, field_of_view_of(a, scale), a.color_space};
  if (interrupted()) throw Cancelled();
  write(a, kernel, t);
  const double taken = *std::ranges::max_element(kernel.image.taken);
  const std::string told =
      text_of("the roll-off at the border leaves %.3g of the light in its own pixel", taken);
  if (taken > 0.01)
    console.warn(told);
  else
    console.tell(told);
  if (const std::string limit = limit_of(a.program, kernel); !limit.empty()) console.warn(limit);
  print(settings_for(a.program, kernel));
}

void add_scale_options(CLI::App& command, ExportArguments& a) {
  const char* const group = "The pictures it is for";
  CLI::Option* const fov =
      command
          .add_option("--fov-deg", a.fov_deg,
                      "Across a picture's width (default: a pixel is one of the template's)")
          ->group(group);
  command.add_option("--pixel-deg", a.pixel_deg, "Degrees of direction sine from pixel to pixel")
      ->group(group)
      ->check(CLI::PositiveNumber)
      ->excludes(fov);
  command
      .add_flag("--perspective", a.perspective,
                "--fov-deg is a perspective camera's: the scale in the picture's middle")
      ->group(group)
      ->needs(fov);
  command.add_option("--picture-width", a.picture_width, "In pixels")
      ->group(group)
      ->check(CLI::Range(1, 65535))
      ->capture_default_str();
}

void add_kernel_options(CLI::App& command, ExportArguments& a) {
  command
      .add_option("--size", a.size,
                  "Width and height in pixels; odd, for Unreal a power of two (default: what "
                  "holds all of the template)")
      ->check(CLI::Range(3, kLargestSize));
  command
      .add_option("--roll-off", a.roll_off,
                  "Share of the radius in which the kernel fades to 0 at the border, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command.add_option("--colorspace", a.color_space, "Of the pictures it is for, as of template")
      ->capture_default_str();
  command.add_option("--ocio", a.ocio, "OpenColorIO config (default: $OCIO)")->check(not_empty());
}

}  // namespace

Command add_export_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "export", "Write a template's kernel for another program's convolution");
  const auto a = std::make_shared<ExportArguments>();
  command.add_option("template", a->input, "Glare template")->required();
  std::vector<std::string> names;
  for (const KernelProgram& known : kernel_programs()) names.emplace_back(known.name);
  command.add_option("--for", a->program, "The program: its file, and what to set there")
      ->required()
      ->check(CLI::IsMember(names));
  command.add_option("-o,--output", a->output, "OpenEXR")->required();
  add_scale_options(command, *a);
  add_kernel_options(command, *a);
  add_threads_option(command, a->threads);
  add_verbosity_options(command, a->quiet, a->verbose);
  return [a] { run_export(*a); };
}

}  // namespace glare::tool
