// Sequences in time.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace glare::tool {

/// How many pictures a command makes, and how fast they follow one another.
struct FrameArguments {
  int count = 1;
  double per_second = 24;
};

/// Adds `--frames`, which it returns, and `--fps`; `arguments` are set when it is parsed, and
/// outlive it.
CLI::Option* add_frame_options(CLI::App& command, FrameArguments& arguments);

/// When a frame, counted from 0, is, after the time that the sequence begins at.
inline double time_of_frame_s(const FrameArguments& arguments, int frame) {
  return frame / arguments.per_second;
}

/// A file's name with every "{frame}" replaced by the frame's number, counted from 1, of at least
/// four digits.
std::string with_frame(const std::string& pattern, int frame);

/// Throws `OptionError` for one frame in `pattern`s with "{frame}" missing where there are several.
void require_frame_in(const std::string& option, const std::string& pattern,
                      const FrameArguments& arguments);

}  // namespace glare::tool
