#include "apply/apply_arguments.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "common_options.h"
#include "file_names.h"
#include "glare/base/error.h"
#include "glare/io/memory.h"

namespace glare::tool {

namespace {

/// Of a given option that is a number; NaN is in no range.
void require_within(const std::string& option, double value, double low, double high,
                    const std::string& expected) {
  if (!(value >= low && value <= high))
    throw OptionError(option + " is out of range: expected " + expected);
}

void add_scale_options(CLI::App& command, ApplyArguments& a) {
  const char* const group = "The picture's angles (default: as its camera attributes tell)";
  auto* const fov = command.add_option("--fov-deg", a.fov_deg,
                                       "Field of view across the picture's width, in degrees; the "
                                       "template's degrees are divided among the pixels evenly");
  auto* const pixel = command.add_option("--pixel-deg", a.pixel_deg,
                                         "Degrees from pixel to pixel, in the picture's middle");
  auto* const perspective =
      command.add_flag("--perspective", a.perspective,
                       "--fov-deg is a perspective picture's: its middle pixels are "
                       "2 tan(D/2) / width wide");
  pixel->excludes(fov);
  perspective->needs(fov);
  for (CLI::Option* option : {fov, pixel, perspective}) option->group(group);
}

void add_light_options(CLI::App& command, ApplyArguments& a) {
  const char* const group = "Light";
  for (CLI::Option* option :
       {command.add_option("--exposure", a.bright.exposure_stops,
                           "Multiply the picture by 2^STOPS first, -64 to 64"),
        command.add_option("--threshold", a.bright.threshold,
                           "Only light above this luminance is spread, in the exposed picture's "
                           "unit; 0: all light"),
        command.add_option("--knee", a.bright.knee,
                           "Half width of the soft step at the threshold, as a share of it, 0 to "
                           "1"),
        command.add_option("--strength", a.strength,
                           "Of the change: 1 is physically right, 0 changes nothing; 0 to 1000"),
        command.add_option("--roll-off", a.roll_off,
                           "Share of the kernel's radius in which it fades to 0 at its border, 0 "
                           "to 1: hides the square border around very bright lights")})
    option->capture_default_str()->group(group);
  command
      .add_flag("--only-glare", a.only_glare,
                "Write what is added alone, negative where light was taken to be spread")
      ->group(group);
  command
      .add_option("--edge", a.edge,
                  "Beyond the picture's border: black, or its border's own values go on (extend)")
      ->check(CLI::IsMember({"black", "extend"}))
      ->capture_default_str()
      ->group(group);
  command
      .add_option("--lamp-color", a.lamp_color,
                  "divide: white light stays white as a whole, whatever lamp the template is of; "
                  "keep: it gets the lamp's colour")
      ->check(CLI::IsMember({"divide", "keep"}))
      ->capture_default_str()
      ->group(group);
  auto* const sources =
      command
          .add_option("--sources", a.sources,
                      "auto: by the brightest pixels where they hold all but 0.05 % of the light; "
                      "FILE: by these points alone, rows x_px,y_px,red,green,blue")
          ->type_name("auto|FILE")
          ->check(not_empty())
          ->group(group);
  command
      .add_flag("--new-sources", a.new_sources,
                "The points of --sources FILE aren't in the picture yet")
      ->needs(sources)
      ->group(group);
}

void add_file_options(CLI::App& command, ApplyArguments& a) {
  const char* const group = "Files";
  for (CLI::Option* option :
       {command.add_option("--colorspace", a.color_space,
                           "The picture's, where its file tells none or a wrong one: a built-in "
                           "name or a scene-linear space of an OpenColorIO config"),
        command.add_option("--ocio", a.ocio, "Config (default: $OCIO)"),
        command.add_option("--layer", a.layer, "Channels LAYER.R, LAYER.G, LAYER.B")})
    option->check(not_empty())->group(group);
  command.add_option("--part", a.part, "Of a multi-part file, from 0 (default: the first)")
      ->check(CLI::Range(0, 65535))
      ->group(group);
  auto* const frames =
      command
          .add_option("--frames", a.frames,
                      "A sequence: 1-240, 1-240x2 (every second), 7, or several with commas; %04d, "
                      "#### or {frame} in both names stands for the number")
          ->check(not_empty())
          ->group(group);
  command
      .add_flag("--resume", a.resume,
                "Keep the frames of an interrupted sequence that are whole and of these inputs")
      ->needs(frames)
      ->group(group);
}

}  // namespace

std::uint64_t ApplyArguments::memory_bytes() const {
  return memory_limit_bytes ? memory_limit_bytes : default_memory_limit_bytes();
}

PixelKernelOptions::LampColor ApplyArguments::lamp_color_kind() const {
  using LampColor = PixelKernelOptions::LampColor;
  return lamp_color == "keep" ? LampColor::kept : LampColor::divided_out;
}

void add_apply_options(CLI::App& command, ApplyArguments& a) {
  command
      .add_option(
          "picture", a.input,
          "Scene-linear picture, OpenEXR or Radiance HDR; all that isn't its colour is kept")
      ->required()
      ->check(not_empty());
  command.add_option("--template", a.glare_template, "The glare template (OpenEXR)")
      ->required()
      ->check(not_empty());
  command.add_option("-o,--output", a.output, "Picture to write, .exr or .hdr")
      ->required()
      ->check(not_empty());
  add_scale_options(command, a);
  add_light_options(command, a);
  add_file_options(command, a);
  add_threads_option(command, a.threads);
  add_memory_limit_option(command, a.memory_limit_bytes);
  add_verbosity_options(command, a.quiet, a.verbose);
}

void require_consistent(const ApplyArguments& a) {
  const std::string ending = ending_of(a.output);
  if (ending != ".exr" && ending != ".hdr")
    throw OptionError("--output " + a.output + ": expected a name that ends in .exr or .hdr");
  if (a.fov_deg && !(*a.fov_deg > 0 && *a.fov_deg < 180))
    throw OptionError("--fov-deg is out of range: expected above 0 and below 180");
  if (a.pixel_deg && !(*a.pixel_deg > 0 && *a.pixel_deg <= 57))
    throw OptionError("--pixel-deg is out of range: expected above 0 and at most 57");
  require_within("--exposure", a.bright.exposure_stops, -64, 64, "-64 to 64");
  require_within("--threshold", a.bright.threshold, 0, 1e30, "0 to 1e30");
  require_within("--knee", a.bright.knee, 0, 1, "0 to 1");
  require_within("--strength", a.strength, 0, 1000, "0 to 1000");
  require_within("--roll-off", a.roll_off, 0, 1, "0 to 1");
  if (!a.ocio.empty() && a.color_space.empty()) throw OptionError("--ocio goes with --colorspace");
  if (a.roll_off > 0 && !a.sources.empty())
    throw OptionError("--roll-off: points (--sources) get the whole kernel");
  if (a.new_sources && !a.has_sources_file())
    throw OptionError("--new-sources goes with --sources FILE");
  if (a.has_sources_file() && a.bright.threshold > 0)
    throw OptionError("--threshold: the points of --sources FILE are spread whole");
  if (a.has_sources_file() && a.edge_kind() == Edge::extend)
    throw OptionError("--edge extend: nothing but the points of --sources FILE is spread");
}

std::string description_of(const ApplyArguments& a) {
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
  };
  return nlohmann::ordered_json{{"fov_deg", number(a.fov_deg)},
                                {"pixel_deg", number(a.pixel_deg)},
                                {"perspective", a.perspective},
                                {"edge", a.edge},
                                {"exposure", a.bright.exposure_stops},
                                {"threshold", a.bright.threshold},
                                {"knee", a.bright.knee},
                                {"strength", a.strength},
                                {"roll_off", a.roll_off},
                                {"only_glare", a.only_glare},
                                {"lamp_color", a.lamp_color},
                                {"part", a.part},
                                {"layer", a.layer},
                                {"sources", a.has_sources_file() ? "file" : a.sources},
                                {"new_sources", a.new_sources},
                                {"ending", ending_of(a.output)},
                                {"memory_limit", a.memory_limit_bytes}}
      .dump();
}

}  // namespace glare::tool
