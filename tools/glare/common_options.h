// Options that several commands have.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace glare::tool {

/// For options that name something.
CLI::Validator not_empty();

/// Adds `--threads`.
void add_threads_option(CLI::App& command, int& threads);

/// Adds `--memory-limit`; 0 stays 0 where it isn't given.
void add_memory_limit_option(CLI::App& command, std::uint64_t& bytes);

/// Adds `--quiet` and `--verbose`, which exclude one another.
void add_verbosity_options(CLI::App& command, bool& quiet, bool& verbose);

/// Width and height of the option `--size`, "512" or "640x480". Throws `OptionError`.
std::array<int, 2> size_px_from(const std::string& text);

}  // namespace glare::tool
