// The program `glare`: glare templates from an eye's aperture and a lamp's spectrum.

#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <vector>

#include "commands.h"
#include "console.h"
#include "glare/base/error.h"
#include "interruption.h"

namespace {

using namespace glare;

/// Exit statuses, as docs/conventions.md lists them.
enum ExitStatus {
  done = 0,
  failed = 1,
  bad_usage = 2,
  bad_input = 3,
  bad_output = 4,
  no_memory = 5
};

int report(const std::string& message, ExitStatus status) {
  tool::print_error(message);
  return status;
}

/// The exit status for the exception being handled, after a message that tells it.
int report_current_exception() {
  try {
    throw;
  } catch (const Cancelled&) {
    return tool::interrupted() ? tool::interruption_exit_status() : failed;
  } catch (const OptionError& error) {
    return report(error.what(), bad_usage);
  } catch (const InputError& error) {
    return report(error.what(), bad_input);
  } catch (const OutputError& error) {
    return report(error.what(), bad_output);
  } catch (const MemoryError& error) {
    return report(error.what(), no_memory);
  } catch (const std::bad_alloc&) {
    return report("out of memory", no_memory);
  } catch (const std::exception& error) {
    return report(error.what(), failed);
  }
}

struct Subcommand {
  CLI::App* app;
  tool::Command run;
};

int run(int argument_count, char** arguments) {
  CLI::App program{
      "Makes glare templates: the linear HDR picture of what an eye sees around a bright point "
      "because light is diffracted at its pupil and eyelashes."};
  program.name("glare");
  program.set_version_flag("--version", "glare " GLARE_VERSION);
  program.require_subcommand(1);
  program.failure_message([](const CLI::App*, const CLI::Error& error) {
    tool::print_error(error.what() + std::string(" (see glare --help)"));
    return std::string();
  });

  std::vector<Subcommand> subcommands;
  for (const auto add :
       {tool::add_template_command, tool::add_info_command, tool::add_lamps_command,
        tool::add_aperture_command, tool::add_photometry_command, tool::add_tonemap_command,
        tool::add_headlamp_command, tool::add_apply_command, tool::add_export_command}) {
    tool::Command command = add(program);
    subcommands.push_back({program.get_subcommands({}).back(), std::move(command)});
  }
  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    if (argument_count > 1 && error.get_exit_code() != 0 && program.get_subcommands().empty())
      throw OptionError("expected a command, found '" + std::string(arguments[1]) +
                        "' (see glare --help)");
    if (program.exit(error) != 0) return bad_usage;
    tool::print("");  // Notices where the help could not be written.
    return done;
  }
  for (const Subcommand& subcommand : subcommands)
    if (subcommand.app->parsed()) subcommand.run();
  return done;
}

}  // namespace

int main(int argument_count, char** arguments) {
  tool::watch_for_interruption();
  try {
    return run(argument_count, arguments);
  } catch (...) {
    return report_current_exception();
  }
}
