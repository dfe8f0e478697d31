// glare lamps: the lamps that are built in.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "console.h"
#include "glare/glare.h"

namespace glare::tool {

namespace {

constexpr WavelengthRange kVisible_nm = {360, 830};

Chromaticity chromaticity_of(const Spectrum& lamp) {
  const auto& observer = color_matching_functions("cie1931-2deg");
  return chromaticity(xyz_from_spectrum(lamp, observer, kVisible_nm));
}

std::string lamps_as_json() {
  auto list = nlohmann::ordered_json::array();
  for (const BuiltInLamp& lamp : built_in_lamps()) {
    const Spectrum spectrum = *find_lamp(lamp.name);
    const Chromaticity xy = chromaticity_of(spectrum);
    list.push_back({{"name", lamp.name},
                    {"alias", lamp.alias},
                    {"description", lamp.description},
                    {"cie1931_xy", {xy.x, xy.y}},
                    {"range_nm", {spectrum.range().lo_nm, spectrum.range().hi_nm}}});
  }
  return list.dump(2) + "\n";
}

std::string lamps_as_text() {
  std::string text = "name      alias    x (1931)  y       what it is\n";
  for (const BuiltInLamp& lamp : built_in_lamps()) {
    const Chromaticity xy = chromaticity_of(*find_lamp(lamp.name));
    char line[200];
    std::snprintf(line, sizeof line, "%-9s %-8s %.4f    %.4f  %s\n", lamp.name.c_str(),
                  lamp.alias.c_str(), xy.x, xy.y, lamp.description.c_str());
    text += line;
  }
  return text +
         "blackbody:KELVIN  a black body, 500 to 100000 K\n"
         "FILE.csv          rows of wavelength_nm,power\n";
}

}  // namespace

Command add_lamps_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("lamps", "List the built-in lamps");
  const auto as_json = std::make_shared<bool>(false);
  command.add_flag("--json", *as_json, "As JSON");
  return [as_json] { print(*as_json ? lamps_as_json() : lamps_as_text()); };
}

}  // namespace glare::tool
