// A text of numbers only, one after the other, over any number of lines. Internal.
#pragma once

#include <string>
#include <string_view>

#include "glare/base/error.h"
#include "glare/photometry/text_reading.h"

namespace glare::photometry {

/// Numbers parted by blanks, tabs, ends of lines or one comma.
class NumberStream {
 public:
  struct Field {
    std::string_view text;  ///< Empty at the end.
    int line = 0;
    bool first_on_line = false;
  };

  /// Goes on where `lines` is.
  NumberStream(Lines lines, std::string place) : lines_(lines), place_(std::move(place)) {}

  /// The next field. Throws `InputError` where there is nothing between two commas.
  Field next();

  /// The next number. `what()` names it in errors: of the end, or of something else than a number.
  template <typename What>
  double number(const What& what) {
    field_ = next();
    if (field_.text.empty())
      throw InputError(at_line(place_, field_.line), "the file ends before " + std::string(what()));
    const auto number = finite_number_from(field_.text);
    if (!number)
      throw InputError(here(),
                       quoted(field_.text) + " is no number; expected " + std::string(what()));
    return *number;
  }

  /// The next number, from `low` to `high`.
  double number_within(const char* what, double low, double high);
  /// The next number, a whole one from `low` to `high`.
  int whole_number(const char* what, int low, int high);

  /// Where the last field stood.
  std::string here() const { return at_line(place_, field_.line); }
  const Field& last() const { return field_; }

 private:
  Lines lines_;
  std::string place_;
  std::string_view line_;
  Field field_;
  bool line_is_fresh_ = false;
  bool after_comma_ = false;
};

}  // namespace glare::photometry
