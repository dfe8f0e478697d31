#include "frames.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "glare/base/error.h"

namespace glare::tool {

namespace {

const std::string kPlaceholder = "{frame}";

}  // namespace

CLI::Option* add_frame_options(CLI::App& command, FrameArguments& arguments) {
  const std::string group = "Built-in eye: motion";
  auto* const frames =
      command
          .add_option("--frames", arguments.count,
                      "Make a sequence of so many, from --time-s on; {frame} in a file's name "
                      "stands for the number, from 0001 on")
          ->check(CLI::Range(1, 100000))
          ->capture_default_str()
          ->group(group);
  command.add_option("--fps", arguments.per_second, "Frames per second of the sequence")
      ->check(CLI::Range(0.001, 100000.0))
      ->capture_default_str()
      ->needs(frames)
      ->group(group);
  return frames;
}

std::string with_frame(const std::string& pattern, int frame) {
  char number[16];
  std::snprintf(number, sizeof number, "%04d", frame + 1);
  std::string result = pattern;
  for (std::size_t at = 0; (at = result.find(kPlaceholder, at)) != std::string::npos;)
    result.replace(at, kPlaceholder.size(), number);
  return result;
}

void require_frame_in(const std::string& option, const std::string& pattern,
                      const FrameArguments& arguments) {
  if (arguments.count > 1 && !pattern.empty() && pattern.find(kPlaceholder) == std::string::npos)
    throw OptionError(option + " " + pattern +
                      ": expected {frame} in the name, since there are several frames");
}

}  // namespace glare::tool
