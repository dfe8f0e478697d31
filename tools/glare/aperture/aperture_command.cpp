// glare aperture: apertures to make templates of.

#include <CLI/CLI.hpp>
#include <utility>
#include <vector>

#include "commands.h"

namespace glare::tool {

Command add_aperture_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("aperture", "Make the pictures of an aperture");
  command.require_subcommand(1);
  std::vector<std::pair<CLI::App*, Command>> kinds;
  for (const auto add :
       {add_aperture_eye_command, add_aperture_diaphragm_command, add_aperture_photo_command}) {
    Command run = add(command);
    kinds.emplace_back(command.get_subcommands({}).back(), std::move(run));
  }
  return [kinds] {
    for (const auto& [kind, run] : kinds)
      if (kind->parsed()) run();
  };
}

}  // namespace glare::tool
