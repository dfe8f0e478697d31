// glare aperture diaphragm: the picture of a camera lens's iris.

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "aperture/aperture_outputs.h"
#include "commands.h"
#include "glare/aperture/diaphragm.h"
#include "glare/io/aperture_file.h"
#include "interruption.h"

namespace glare::tool {

namespace {

struct DiaphragmArguments {
  DiaphragmParameters parameters;
  DrawingArguments drawing;
  std::string output;
};

std::vector<OptionText> recipe_options(const DiaphragmParameters& p, int size) {
  return {{"--diameter-mm", {text_of(p.diameter_mm)}},
          {"--blades", {std::to_string(p.blade_count)}},
          {"--roundness", {text_of(p.roundness)}},
          {"--rotation-deg", {text_of(p.rotation_deg)}},
          {"--dust", {std::to_string(p.dust_count)}},
          {"--dust-diameter-mm", {text_of(p.dust_diameter_mm)}},
          {"--scratches", {std::to_string(p.scratch_count)}},
          {"--scratch-length-mm", {text_of(p.scratch_length_mm)}},
          {"--scratch-width-mm", {text_of(p.scratch_width_mm)}},
          {"--seed", {std::to_string(p.seed)}},
          {"--size", {std::to_string(size)}}};
}

void run_diaphragm(const DiaphragmArguments& a) {
  require_pictures({a.output});
  require_valid(a.parameters);
  const double pixel = pixel_mm(a.drawing, diaphragm_picture_width_mm(a.parameters));
  const Aperture drawn =
      draw_diaphragm(a.parameters, pixel, a.drawing.threads,
                     Console(a.drawing.verbosity()).progress("glare aperture diaphragm"));
  const auto options = recipe_options(a.parameters, drawn.transmittance.width());
  write_aperture(a.output, drawn, aperture_recipe("diaphragm", options),
                 [] { return !interrupted(); });
}

void add_shape_options(CLI::App& command, DiaphragmParameters& p) {
  const auto add = [&](const char* name, auto& value, const char* help) {
    command.add_option(name, value, help)->capture_default_str();
  };
  add("--diameter-mm", p.diameter_mm, "Of the circle through the corners");
  add("--blades", p.blade_count, "3 to 32");
  add("--roundness", p.roundness, "Of the blades' edges: 0 straight, 1 a circle");
  add("--rotation-deg", p.rotation_deg, "Clockwise; at 0 a corner points up");
  add("--dust", p.dust_count, "Specks of dust");
  add("--dust-diameter-mm", p.dust_diameter_mm, "Their mean diameter");
  add("--scratches", p.scratch_count, "Scratches");
  add("--scratch-length-mm", p.scratch_length_mm, "Their mean length");
  add("--scratch-width-mm", p.scratch_width_mm, "Their width in the middle");
  add("--seed", p.seed, "Where dust and scratches are");
}

}  // namespace

Command add_aperture_diaphragm_command(CLI::App& aperture) {
  CLI::App& command =
      *aperture.add_subcommand("diaphragm", "Draw the diaphragm of a camera's lens");
  const auto arguments = std::make_shared<DiaphragmArguments>();
  command.add_option("-o,--output", arguments->output, "OpenEXR (.exr) or 16-bit PNG (.png)")
      ->required();
  add_shape_options(command, arguments->parameters);
  add_drawing_options(command, arguments->drawing);
  return [arguments] { run_diaphragm(*arguments); };
}

}  // namespace glare::tool
