// What the program says to a person: one line a message, and a progress bar on a terminal.
#pragma once

#include <chrono>
#include <string>

#include "glare/base/progress.h"

namespace glare::tool {

/// How much is said on the error stream.
enum class Verbosity { quiet, normal, verbose };

class Console {
 public:
  explicit Console(Verbosity verbosity) : verbosity_(verbosity) {}

  /// "glare: warning: ..."; not when quiet.
  void warn(const std::string& message) const;
  /// A line that only `--verbose` shows.
  void tell(const std::string& message) const;
  /// A progress bar, on a terminal only, which also notices an interruption.
  ProgressCallback progress(const std::string& label) const;

 private:
  Verbosity verbosity_;
};

/// "glare: error: ..." on the error stream, in one line.
void print_error(const std::string& message);

/// Text on standard output; throws `OutputError` where it can't be written.
void print(const std::string& text);

}  // namespace glare::tool
