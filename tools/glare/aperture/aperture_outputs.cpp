#include "aperture/aperture_outputs.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "common_options.h"
#include "file_names.h"
#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/memory.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;

bool is_picture(const std::string& file) {
  const std::string ending = ending_of(file);
  return ending == ".exr" || ending == ".png";
}

/// The samples, and as a PNG file before and after its compression.
void require_memory(double pixels) {
  constexpr double kBytesPerPixel = 4 + 2 + 2 * 2.1;
  const double needed = pixels * kBytesPerPixel;
  const std::uint64_t allowed = default_memory_limit_bytes();
  if (needed > static_cast<double>(allowed))
    throw MemoryError(static_cast<std::uint64_t>(needed), allowed);
}

}  // namespace

void add_drawing_options(CLI::App& command, DrawingArguments& arguments) {
  auto* const size = command.add_option("--size", arguments.size, "Pixels, both ways")
                         ->check(CLI::Range(16, 65535));
  command.add_option("--pixel-um", arguments.pixel_um, "Largest pixel (default 4)")->excludes(size);
  add_threads_option(command, arguments.threads);
  command.add_flag("--quiet", arguments.quiet, "No progress bar");
}

double pixel_mm(const DrawingArguments& arguments, double width_mm) {
  constexpr double kUsual_um = 4, kMost = 65535;
  const double asked_mm =
      arguments.size ? width_mm / *arguments.size : arguments.pixel_um.value_or(kUsual_um) / 1000;
  if (!(asked_mm > 0 && width_mm / asked_mm <= kMost))
    throw OptionError("--pixel-um must be above 0, and give at most 65535 pixels");
  const double side = std::ceil(width_mm / asked_mm * (1 - 1e-12));
  require_memory(side * side);
  return asked_mm;
}

void require_pictures(const std::vector<std::string>& files) {
  std::set<fs::path> taken;
  for (const std::string& file : files) {
    if (!is_picture(file)) throw OptionError(file + ": expected a name that ends in .exr or .png");
    if (!taken.insert(canonical(file)).second)
      throw OptionError(file + ": another output has the same name");
    require_writable(file);
  }
}

std::string aperture_recipe(const std::string& what, const std::vector<OptionText>& options) {
  nlohmann::ordered_json command = {"glare", "aperture", what};
  for (const OptionText& option : options) {
    command.push_back(option.name);
    for (const std::string& value : option.values) command.push_back(value);
  }
  return nlohmann::ordered_json{{"command", command}}.dump(-1, ' ', true);
}

}  // namespace glare::tool
