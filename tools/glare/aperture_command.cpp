// glare aperture: apertures to make templates of.

#include <CLI/CLI.hpp>

#include "commands.h"

namespace glare::tool {

Command add_aperture_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand("aperture", "Make the pictures of an aperture");
  command.require_subcommand(1);
  return add_aperture_photo_command(command);
}

}  // namespace glare::tool
