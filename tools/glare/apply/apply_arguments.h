// What the command line of glare apply says.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "console.h"
#include "glare/convolution/glare_filter.h"
#include "glare/convolution/pixel_kernel.h"

namespace CLI {
class App;
}

namespace glare::tool {

struct ApplyArguments {
  std::string input, glare_template, output;
  std::optional<double> fov_deg, pixel_deg;
  bool perspective = false;
  std::string edge = "black";
  BrightPartOptions bright;
  double strength = 1;
  double roll_off = 0;  ///< Share of the kernel's radius in which it fades out.
  bool only_glare = false;
  std::string lamp_color = "divide";
  std::string color_space, ocio;
  int part = -1;  ///< -1: the first.
  std::string layer;
  std::string sources;  ///< Empty, "auto" or a file.
  bool new_sources = false;
  std::string frames;
  bool resume = false;
  int threads = 0;
  std::uint64_t memory_limit_bytes = 0;
  bool quiet = false, verbose = false;

  Verbosity verbosity() const {
    return quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal;
  }
  Edge edge_kind() const { return edge == "extend" ? Edge::extend : Edge::black; }
  bool has_sources_file() const { return !sources.empty() && sources != "auto"; }
  std::uint64_t memory_bytes() const;
  PixelKernelOptions::LampColor lamp_color_kind() const;
};

/// Adds the options to the subcommand; `arguments` are set when it is parsed, and outlive it.
void add_apply_options(CLI::App& command, ApplyArguments& arguments);

/// Throws `OptionError` where options contradict one another or mean nothing.
void require_consistent(const ApplyArguments& arguments);

/// Every option that the pictures depend on, in one line, for the key of a sequence's frames.
std::string description_of(const ApplyArguments& arguments);

}  // namespace glare::tool
