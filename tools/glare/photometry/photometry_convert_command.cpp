// glare photometry convert: a luminous intensity distribution as an image of candela.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "commands.h"
#include "common_options.h"
#include "console.h"
#include "file_names.h"
#include "glare/base/error.h"
#include "glare/base/range_check.h"
#include "glare/io/atomic_file.h"
#include "glare/io/memory.h"
#include "glare/io/photometry_file.h"
#include "interruption.h"
#include "photometry/photometry_arguments.h"

namespace glare::tool {

namespace {

struct ConvertArguments {
  PhotometryInput input;
  std::string output;
  std::optional<std::array<double, 2>> h_deg, v_deg;
  std::string size;
  Mounting mounting;
  std::optional<std::string> gamma_zero;
  int threads = 0;
};

/// Of the pixels, where no size is given.
constexpr double kUsualStep_deg = 0.1;

int usual_count(const std::array<double, 2>& range_deg) {
  const double steps = std::round((range_deg[1] - range_deg[0]) / kUsualStep_deg);
  return static_cast<int>(std::clamp(steps + 1, 2.0, 65535.0));
}

IntensityGrid grid_of(const ConvertArguments& a) {
  IntensityGrid grid;
  grid.h_deg = a.h_deg.value_or(grid.h_deg);
  grid.v_deg = a.v_deg.value_or(grid.v_deg);
  const auto size = a.size.empty() ? std::array{usual_count(grid.h_deg), usual_count(grid.v_deg)}
                                   : size_px_from(a.size);
  grid.width = size[0];
  grid.height = size[1];
  require_intensity_grid(grid);
  return grid;
}

/// The intensities in the order of angles and in that of rows, and a part of the file.
void require_memory(const IntensityGrid& grid) {
  constexpr std::uint64_t kBytesPerPixel = 3 * sizeof(float);
  const std::uint64_t needed = kBytesPerPixel * static_cast<std::uint64_t>(grid.width) *
                               static_cast<std::uint64_t>(grid.height);
  const std::uint64_t allowed = default_memory_limit_bytes();
  if (needed > allowed) throw MemoryError(needed, allowed);
}

void require_output(const ConvertArguments& a) {
  if (same_file(a.output, a.input.file))
    throw OptionError("the output " + a.output + " is an input too");
  if (ending_of(a.output) != ".exr")
    throw OptionError("--output " + a.output + ": expected a name that ends in .exr");
  require_writable(a.output);
}

Mounting mounting_of(const ConvertArguments& a, PhotometricType type) {
  Mounting mounting = a.mounting;
  if (a.gamma_zero && type != PhotometricType::c)
    throw OptionError("--gamma-zero is for files of type C; this one is of type " +
                      std::string(type == PhotometricType::a ? "A" : "B"));
  mounting.gamma_zero_is_forward = a.gamma_zero == "forward";
  return mounting;
}

void require_angles(const Mounting& mounting) {
  require_in_range("--yaw-deg", mounting.yaw_deg, -360, 360);
  require_in_range("--pitch-deg", mounting.pitch_deg, -360, 360);
  require_in_range("--roll-deg", mounting.roll_deg, -360, 360);
}

void run_convert(const ConvertArguments& a) {
  require_output(a);
  require_angles(a.mounting);
  const IntensityGrid grid = grid_of(a);
  require_memory(grid);
  const PhotometricData data = photometry_from(a.input);
  const Mounting mounting = mounting_of(a, data.distribution.type());
  tell_warnings(a.input, data.info);
  if (interrupted()) throw Cancelled();
  const Console console(a.input.quiet ? Verbosity::quiet : Verbosity::normal);
  write_intensity_image(a.output, data.distribution, grid, mounting, a.threads,
                        console.progress("glare photometry convert"));
}

void add_mounting_options(CLI::App& command, ConvertArguments& a) {
  const auto turn = [&](const char* name, double& angle, const char* help) {
    command.add_option(name, angle, help)->type_name("DEG")->capture_default_str();
  };
  command
      .add_option("--gamma-zero", a.gamma_zero,
                  "Of type C: where gamma 0 is, down (default) as for luminaires, or forward")
      ->check(CLI::IsMember({"down", "forward"}));
  turn("--yaw-deg", a.mounting.yaw_deg, "Turns the lamp, right positive; after pitch and roll");
  turn("--pitch-deg", a.mounting.pitch_deg, "Up positive; after roll");
  turn("--roll-deg", a.mounting.roll_deg, "About its axis, clockwise as seen from behind it");
}

}  // namespace

Command add_photometry_convert_command(CLI::App& photometry) {
  CLI::App& command = *photometry.add_subcommand(
      "convert", "Write a photometric file's intensities as an image over H and V");
  const auto arguments = std::make_shared<ConvertArguments>();
  add_photometry_input(command, arguments->input, "--input-");
  command
      .add_option("-o,--output", arguments->output,
                  "OpenEXR: one channel, in candela; tells its degrees")
      ->required();
  add_range_option(command, "--h-deg", arguments->h_deg,
                   "H of the centres of the first and last column (default -90 90)");
  add_range_option(command, "--v-deg", arguments->v_deg,
                   "V of the centres of the bottom and top row (default -90 90)");
  command.add_option("--size", arguments->size, "Pixels, N or WxH (default: steps of 0.1 degrees)");
  add_mounting_options(command, *arguments);
  add_threads_option(command, arguments->threads);
  return [arguments] { run_convert(*arguments); };
}

}  // namespace glare::tool
