#include "console.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>

#include "glare/base/error.h"
#include "interruption.h"

namespace glare::tool {

namespace {

constexpr int kBarWidth = 40;

void print_line(const std::string& kind, const std::string& message) {
  std::string line = "glare: " + kind + ": " + message;
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  std::fprintf(stderr, "%s\n", line.c_str());
}

/// Draws the bar anew when there is something to see, and wipes it at the end.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label) : label_(std::move(label)) {}
  ~ProgressBar() {
    if (drawn_) std::fprintf(stderr, "\r\033[K");
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    drawn_ = true;
    const int filled = static_cast<int>(fraction * kBarWidth);
    std::fprintf(stderr, "\r%s [%s%s] %3.0f%%", label_.c_str(), std::string(filled, '#').c_str(),
                 std::string(kBarWidth - filled, ' ').c_str(), 100 * fraction);
    std::fflush(stderr);
  }

 private:
  std::string label_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  bool drawn_ = false;
};

}  // namespace

void Console::warn(const std::string& message) const {
  if (verbosity_ != Verbosity::quiet) print_line("warning", message);
}

void Console::tell(const std::string& message) const {
  if (verbosity_ == Verbosity::verbose) print_line("note", message);
}

ProgressCallback Console::progress(const std::string& label) const {
  if (verbosity_ == Verbosity::quiet || isatty(STDERR_FILENO) == 0)
    return [](double) { return !interrupted(); };
  const auto bar = std::make_shared<ProgressBar>(label);
  return [bar](double fraction) {
    bar->show(fraction);
    return !interrupted();
  };
}

void print_error(const std::string& message) { print_line("error", message); }

void print(const std::string& text) {
  std::cout << text << std::flush;
  if (!std::cout) throw OutputError("standard output", "can't be written");
}

}  // namespace glare::tool
