// glare tonemap: a linear picture or a template brought to a display.

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "common_options.h"
#include "console.h"
#include "file_names.h"
#include "glare/glare.h"
#include "glare/glare_io.h"
#include "interruption.h"

namespace glare::tool {

namespace {

struct TonemapArguments {
  std::string input, output;
  std::string curve = "sigmoid", transfer = "srgb";
  bool per_channel = false;
  std::optional<double> adaptation_luminance, illuminance_lux;
  ToneMapping mapping;
  double scale = 1;
  int bits = 8;
  std::string ocio, display, view;
  int threads = 0;
  bool quiet = false, verbose = false;

  bool is_exr() const { return ending_of(output) == ".exr"; }
  bool has_view() const { return !ocio.empty() || !display.empty() || !view.empty(); }
  Verbosity verbosity() const {
    return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal;
  }
};

void require_possible(const TonemapArguments& a) {
  if (!a.is_exr() && ending_of(a.output) != ".png")
    throw OptionError("--output " + a.output + ": expected a name that ends in .png or .exr");
  if (a.is_exr() && a.has_view())
    throw OptionError("--output " + a.output +
                      ": a view gives a display's values, and an OpenEXR file holds linear light; "
                      "expected a name that ends in .png");
  for (const std::string& input : {a.input, a.ocio})
    if (!input.empty() && canonical(a.output) == canonical(input))
      throw OptionError("the output " + a.output + " is an input too");
  if (!(std::isfinite(a.scale) && a.scale > 0))
    throw OptionError("--scale must be positive and finite");
  if (a.illuminance_lux && !(std::isfinite(*a.illuminance_lux) && *a.illuminance_lux > 0))
    throw OptionError("--illuminance-lux must be positive and finite");
  require_writable(a.output);
}

std::filesystem::path config_of(const TonemapArguments& a) {
  const std::filesystem::path config =
      a.ocio.empty() ? color_config_from_environment() : std::filesystem::path(a.ocio);
  if (config.empty())
    throw OptionError("--display and --view need an OpenColorIO config: --ocio or $OCIO");
  return config;
}

void multiply(Picture& picture, double factor) {
  if (factor == 1) return;
  for (auto& channel : picture.channels)
    for (float& value : channel.values()) value = static_cast<float>(value * factor);
}

/// The veil that a template means, in cd/m^2, where there are so many lux at the eye.
Picture veil_of(const std::string& file, double illuminance_lux) {
  const ReadTemplateOptions options{default_memory_limit_bytes()};
  GlareTemplate t = read_template(file, options);
  Picture picture{std::move(t.channels), t.color_space};
  multiply(picture, t.per_steradian * illuminance_lux);
  return picture;
}

Picture input_picture(const TonemapArguments& a, const Console& console) {
  if (a.illuminance_lux) return veil_of(a.input, *a.illuminance_lux);
  PictureFile file = read_picture(a.input, default_memory_limit_bytes());
  for (const std::string& warning : file.warnings) console.warn(a.input + ": " + warning);
  if (file.was_display_encoded)
    console.tell(a.input + ": its values are taken for sRGB's, and 1 for their white");
  multiply(file.picture, a.scale);
  return std::move(file.picture);
}

ToneMapping mapping_of(const TonemapArguments& a, const Picture& picture, const Console& console) {
  ToneMapping mapping = a.mapping;
  const bool linear = a.curve == "linear";
  mapping.curve = linear ? ToneMapping::Curve::linear : ToneMapping::Curve::tumblin_sigmoid;
  mapping.application =
      a.per_channel ? ToneMapping::Application::per_channel : ToneMapping::Application::luminance;
  mapping.transfer = a.transfer == "none" || a.is_exr() ? ToneMapping::Transfer::none
                                                        : ToneMapping::Transfer::srgb;
  if (linear) return mapping;
  mapping.adaptation_luminance = a.adaptation_luminance
                                     ? *a.adaptation_luminance
                                     : median_luminance(picture.channels, picture.color_space);
  char text[100];
  std::snprintf(text, sizeof text, "adaptation luminance %.6g%s", mapping.adaptation_luminance,
                a.adaptation_luminance ? "" : ", the picture's median");
  console.tell(text);
  return mapping;
}

Picture as_picture(const Image<std::array<float, 3>>& rgb) {
  Picture picture;
  picture.channels.fill(Image<float>(rgb.width(), rgb.height()));
  for (std::size_t i = 0; i < rgb.values().size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) picture.channels[k].values()[i] = rgb.values()[i][k];
  return picture;
}

Image<std::array<float, 3>> shown(Picture& picture, const TonemapArguments& a,
                                  const Console& console) {
  if (!a.has_view()) return tone_mapped(picture, mapping_of(a, picture, console), a.threads);
  multiply(picture, std::exp2(a.mapping.exposure_stops));
  return displayed(picture, config_of(a), a.display, a.view);
}

void run_tonemap(const TonemapArguments& a) {
  require_possible(a);
  const Console console(a.verbosity());
  const auto keep_going = [] { return !interrupted(); };
  Picture picture = input_picture(a, console);
  if (!keep_going()) throw Cancelled();
  const Image<std::array<float, 3>> display_rgb = shown(picture, a, console);
  if (!keep_going()) throw Cancelled();
  if (a.is_exr()) {
    PictureFileOptions options;
    options.threads = a.threads;
    options.keep_going = keep_going;
    write_picture(a.output, as_picture(display_rgb), options);
  } else {
    write_file_atomically(
        a.output, a.bits == 16 ? encode_png_rgb16(display_rgb) : encode_png_rgb8(display_rgb));
  }
}

/// Each makes no sense beside a view of an OpenColorIO config.
std::vector<CLI::Option*> add_curve_options(CLI::App& command, TonemapArguments& a) {
  const char* const group = "Tone curve";
  std::vector<CLI::Option*> options = {
      command
          .add_option("--curve", a.curve,
                      "sigmoid: D (x^g + 1/k) / (x^g + k), x = L / L_wa (Tumblin, Hodgins and "
                      "Guenter 1999); linear: exposure alone, limited at white")
          ->check(CLI::IsMember({"sigmoid", "linear"}))
          ->capture_default_str(),
      command.add_option("--adaptation-luminance", a.adaptation_luminance,
                         "L_wa of the sigmoid, in the picture's unit, after --scale or "
                         "--illuminance-lux: shown as D / k (default: the picture's median)"),
      command.add_option("--gamma", a.mapping.gamma, "g of the sigmoid: contrast, 0.1 to 10")
          ->capture_default_str(),
      command.add_option("--k", a.mapping.k, "k of the sigmoid: x^g = k is half of D; 1 to 10000")
          ->capture_default_str(),
      command
          .add_option("--display-maximum", a.mapping.display_maximum,
                      "D of the sigmoid; 255 is the display's white")
          ->capture_default_str(),
      command.add_flag("--per-channel", a.per_channel,
                       "The curve of R, G and B by themselves, not of the luminance"),
      command
          .add_option("--transfer", a.transfer,
                      "srgb: the curve gives the display's light, encoded for sRGB; none: it gives "
                      "the PNG's values. An OpenEXR file always holds light")
          ->check(CLI::IsMember({"srgb", "none"}))
          ->capture_default_str()};
  for (CLI::Option* option : options) option->group(group);
  return options;
}

void add_light_options(CLI::App& command, TonemapArguments& a) {
  command
      .add_option("--exposure-stops", a.mapping.exposure_stops, "Multiply light by 2^stops first")
      ->check(CLI::Range(-100.0, 100.0))
      ->capture_default_str();
  auto* const scale =
      command
          .add_option("--scale", a.scale,
                      "Multiply the picture by it first, such as by the cd/m2 of its 1")
          ->capture_default_str();
  command
      .add_option("--illuminance-lux", a.illuminance_lux,
                  "IN is a glare template: show the veil, in cd/m2, of so much light at the eye")
      ->excludes(scale);
}

void add_view_options(CLI::App& command, TonemapArguments& a,
                      const std::vector<CLI::Option*>& curve_options) {
  const char* const group = "OpenColorIO, instead of the tone curve";
  const std::vector<CLI::Option*> options = {
      command.add_option("--ocio", a.ocio, "Config (default: $OCIO)"),
      command.add_option("--display", a.display, "Display of the config (default: the config's)"),
      command.add_option("--view", a.view, "View of the display (default: the display's)")};
  for (CLI::Option* option : options) {
    option->group(group);
    for (CLI::Option* curve : curve_options) option->excludes(curve);
  }
}

}  // namespace

Command add_tonemap_command(CLI::App& program) {
  CLI::App& command =
      *program.add_subcommand("tonemap", "Bring a linear picture or a glare template to a display");
  const auto a = std::make_shared<TonemapArguments>();
  command
      .add_option("picture", a->input,
                  "OpenEXR, Radiance HDR, PFM, or an ordinary picture of sRGB values")
      ->required();
  command
      .add_option("-o,--output", a->output,
                  "PNG for the display, or OpenEXR: the display's linear light, white = 1")
      ->required();
  command.add_option("--bits", a->bits, "Of the PNG; 8 are dithered, 16 rounded")
      ->check(CLI::IsMember({8, 16}))
      ->capture_default_str();
  add_light_options(command, *a);
  add_view_options(command, *a, add_curve_options(command, *a));
  add_threads_option(command, a->threads);
  add_verbosity_options(command, a->quiet, a->verbose);
  return [a] { run_tonemap(*a); };
}

}  // namespace glare::tool
