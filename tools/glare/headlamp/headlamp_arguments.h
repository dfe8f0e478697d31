// What the command line of glare headlamp says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "console.h"

namespace CLI {
class App;
}

namespace glare::tool {

struct HeadlampArguments {
  std::string scene;
  std::string output;
  std::string angles;
  std::string mode;  ///< Empty: as the scene says.
  std::optional<double> relative_luminance;
  std::vector<std::string> reports;
  std::vector<double> report_angles_deg = {1, 2, 5, 10};
  bool resume = false;
  bool check = false;
  int bits = 8;
  bool half = false;
  std::string template_cache;
  int threads = 0;
  std::uint64_t memory_limit_bytes = 0;
  bool quiet = false, verbose = false;

  Verbosity verbosity() const {
    return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal;
  }
  bool writes_exr() const;
};

/// Adds the options to the subcommand; `arguments` are set when it is parsed, and outlive it.
void add_headlamp_options(CLI::App& command, HeadlampArguments& arguments);

/// Throws `OptionError` where options contradict one another or mean nothing.
void require_consistent(const HeadlampArguments& arguments);

}  // namespace glare::tool
