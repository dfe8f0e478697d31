// Lines and numbers of photometric files, whoever wrote them. Internal.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "glare/base/text_fields.h"

namespace glare::photometry {

/// What is left of a text, line by line: lines end with LF, CR LF or CR; a byte order mark before
/// the first one is passed over; Ctrl-Z, the end of a DOS text, ends it.
class Lines {
 public:
  explicit Lines(std::string_view text);
  /// The next line without its end; nothing where there is none.
  std::optional<std::string_view> next();
  /// The number of the line that was returned last, from 1; 0 before the first.
  int number() const { return number_; }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// `number_from` of a field that is a finite number.
std::optional<double> finite_number_from(std::string_view field, bool decimal_comma = false);

/// In quotation marks, shortened, for a message.
std::string quoted(std::string_view text);

/// As few digits as tell it: 22.5, 30.
std::string text_of(double number);

/// Text for people as UTF-8: as it is where it is that, else taken as Latin-1; control characters
/// are blanks.
std::string readable(std::string_view text);

std::string in_upper_case(std::string_view text);

}  // namespace glare::photometry
