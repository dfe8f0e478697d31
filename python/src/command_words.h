// Options in the words of the command line.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace glare::python {

using Words = std::vector<std::string>;

/// Sets what the command's options are bound to. Throws `OptionError` where the command would
/// refuse the words.
void parse(CLI::App& command, Words words);

/// The long names of a command's options, without the hyphens, and how many values each takes.
std::map<std::string, int> options_of(const CLI::App& command);

/// Bytes of a size such as "4GB", as `--memory-limit` has it. Throws `OptionError`.
std::uint64_t memory_bytes(const std::string& size);

}  // namespace glare::python
