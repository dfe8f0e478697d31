#include "common_options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>
#include <system_error>

#include "glare/base/error.h"

namespace glare::tool {

namespace {

std::optional<std::uint64_t> whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end || text.empty()) return std::nullopt;
  return number;
}

/// After AsSizeValue, which lets negative and too large numbers wrap around.
CLI::Validator plausible_bytes() {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 60;
  return CLI::Validator(
      [](std::string& text) {
        const auto bytes = whole_number(text);
        return bytes && *bytes > 0 && *bytes < kMost ? "" : "isn't an amount of memory";
      },
      "");
}

}  // namespace

CLI::Validator not_empty() {
  return CLI::Validator([](std::string& text) { return text.empty() ? "is empty" : ""; }, "");
}

void add_threads_option(CLI::App& command, int& threads) {
  command.add_option("--threads", threads, "0: as many as the machine has")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

void add_memory_limit_option(CLI::App& command, std::uint64_t& bytes) {
  command
      .add_option("--memory-limit", bytes, "Such as 4GB (default: three quarters of the machine's)")
      ->transform(CLI::AsSizeValue(false))
      ->check(plausible_bytes());
}

void add_verbosity_options(CLI::App& command, bool& quiet, bool& verbose) {
  auto* const no_words = command.add_flag("--quiet", quiet, "No warnings, no progress bar");
  command.add_flag("--verbose", verbose, "Say what was made")->excludes(no_words);
}

std::array<int, 2> size_px_from(const std::string& text) {
  const auto cross = text.find('x');
  const auto width = whole_number(text.substr(0, cross));
  const auto height = cross == std::string::npos ? width : whole_number(text.substr(cross + 1));
  constexpr std::uint64_t kLargest = 65535;
  if (!width || !height || *width < 1 || *height < 1 || *width > kLargest || *height > kLargest)
    throw OptionError("--size " + text + ": expected N or WxH, in pixels from 1 to 65535");
  return {static_cast<int>(*width), static_cast<int>(*height)};
}

}  // namespace glare::tool
