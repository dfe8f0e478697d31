// glare photometry: how strong a lamp shines in each direction, from photometric files.

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

#include "commands.h"

namespace glare::tool {

Command add_photometry_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "photometry", "Luminous intensity over direction: IES LM-63, EULUMDAT and images");
  command.require_subcommand(1);
  std::vector<std::pair<CLI::App*, Command>> kinds;
  for (const auto add : {add_photometry_info_command, add_photometry_convert_command}) {
    Command run = add(command);
    kinds.emplace_back(command.get_subcommands({}).back(), std::move(run));
  }
  return [kinds] {
    for (const auto& [kind, run] : kinds)
      if (kind->parsed()) run();
  };
}

}  // namespace glare::tool
