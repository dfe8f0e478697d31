#include "command_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "common_options.h"
#include "glare/base/error.h"

namespace glare::python {

void parse(CLI::App& command, Words words) {
  std::reverse(words.begin(), words.end());  // As CLI11 takes them.
  try {
    command.parse(std::move(words));
  } catch (const CLI::ParseError& error) {
    throw OptionError(error.what());
  }
}

std::map<std::string, int> options_of(const CLI::App& command) {
  std::map<std::string, int> options;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) options[name] = option->get_expected_max();
  return options;
}

std::uint64_t memory_bytes(const std::string& size) {
  CLI::App command;
  std::uint64_t bytes = 0;
  tool::add_memory_limit_option(command, bytes);
  parse(command, {"--memory-limit=" + size});
  return bytes;
}

}  // namespace glare::python
