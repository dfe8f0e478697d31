// The frames of a sequence of files: their numbers, and the numbers in their names.
#pragma once

#include <string>
#include <vector>

namespace glare::tool {

/// The numbers, from 0 to 999999999, that "1-240", "1-240x2" (every second, from the first on),
/// "7" or several of these with commas say: in ascending order, each once, 100000 at most. Throws
/// `OptionError`.
std::vector<int> frame_numbers_from(const std::string& text);

/// A file's name in which a frame's number stands: %d, %4d (blanks in front), %04d, #### or {frame}
/// (four digits at least).
class FrameName {
 public:
  /// Throws `OptionError`, with the option's name, where no number is in the name, or several.
  FrameName(const std::string& option, const std::string& pattern);

  std::string operator()(int frame) const;
  /// The name with {frame} in the place of the number, as `FrameRecord` takes it.
  std::string with_placeholder() const { return before_ + "{frame}" + after_; }

 private:
  std::string before_, after_;
  int digits_ = 0;
  char fill_ = '0';
};

}  // namespace glare::tool
