#include "apply/frame_numbers.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <regex>
#include <string_view>

#include "glare/base/error.h"

namespace glare::tool {

namespace {

constexpr int kMostFrames = 100000;
constexpr int kHighestFrame = 999999999;

std::optional<int> number_from(std::string_view text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end || number < 0 || number > kHighestFrame)
    return std::nullopt;
  return number;
}

/// "1-240x2": its first, last and step.
struct Range {
  int first = 0, last = 0, step = 1;
};

std::optional<Range> range_from(std::string_view text) {
  const auto cross = text.find('x');
  const auto ends = text.substr(0, cross);
  const auto dash = ends.find('-');
  const auto first = number_from(ends.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : number_from(ends.substr(dash + 1));
  const auto step = cross == std::string_view::npos ? 1 : number_from(text.substr(cross + 1));
  if (!first || !last || !step || *last < *first || *step < 1) return std::nullopt;
  return Range{*first, *last, *step};
}

}  // namespace

std::vector<int> frame_numbers_from(const std::string& text) {
  std::vector<int> frames;
  std::string_view rest = text;
  while (true) {
    const auto comma = rest.find(',');
    const auto range = range_from(rest.substr(0, comma));
    if (!range)
      throw OptionError("--frames " + text +
                        ": expected FIRST-LAST, FIRST-LASTxSTEP or a number, from 0 to 999999999, "
                        "or several with commas");
    for (long long frame = range->first; frame <= range->last; frame += range->step) {
      frames.push_back(static_cast<int>(frame));
      if (frames.size() > kMostFrames)
        throw OptionError("--frames " + text + ": expected 100000 frames at most");
    }
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

FrameName::FrameName(const std::string& option, const std::string& pattern) {
  static const std::regex number(R"(%(0?)([1-9]?)d|(#+)|\{frame\})");
  const std::sregex_iterator first(pattern.begin(), pattern.end(), number), none;
  if (first == none)
    throw OptionError(option + " " + pattern +
                      ": expected %04d, #### or {frame} in the name, since there are frames");
  if (std::next(first) != none)
    throw OptionError(option + " " + pattern + ": expected one frame number in the name");
  const std::smatch& found = *first;
  before_ = found.prefix().str();
  after_ = found.suffix().str();
  if (found[0].str()[0] == '%') {
    digits_ = found[2].length() > 0 ? std::stoi(found[2].str()) : 0;
    fill_ = found[1].length() > 0 ? '0' : ' ';
  } else {
    digits_ = found[3].length() > 0 ? static_cast<int>(std::min<long>(found[3].length(), 100)) : 4;
  }
}

std::string FrameName::operator()(int frame) const {
  const std::string number = std::to_string(frame);
  const auto digits = static_cast<std::size_t>(digits_);
  const std::size_t missing = digits > number.size() ? digits - number.size() : 0;
  return before_ + std::string(missing, fill_) + number + after_;
}

}  // namespace glare::tool
