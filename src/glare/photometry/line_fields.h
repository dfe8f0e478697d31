// A text of one field a line, as EULUMDAT has them. Internal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glare/photometry/text_reading.h"

namespace glare::photometry {

/// Takes one line after the other; `what` names the field in errors. All throw `InputError`, whose
/// place is `place`:LINE, where the text ends before the field.
class LineFields {
 public:
  LineFields(std::string_view text, std::string place) : lines_(text), place_(std::move(place)) {}

  std::string text(const char* what);

  /// A number, with a decimal point or comma, from `low` to `high`.
  double number(const char* what, double low, double high);
  /// One that may be empty: 0 then.
  double optional_number(const char* what);
  int whole_number(const char* what, int low, int high);

  /// So many lines of ascending angles, from 0 to `last_deg`.
  std::vector<double> angles_deg(const char* what, int count, double last_deg);

  /// Throws where a number is left over; warns of text.
  void require_end(std::vector<std::string>& warnings);

  /// The place of the last line.
  std::string here() const { return at_line(place_, lines_.number()); }

 private:
  std::string_view next(const char* what);
  double checked(std::string_view field, const char* what, double low, double high) const;

  Lines lines_;
  std::string place_;
};

}  // namespace glare::photometry
