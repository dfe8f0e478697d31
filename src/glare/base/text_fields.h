// Lines and numbers of tables in text files. Internal.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glare {

/// Without blanks, tabs and ends of lines at both ends.
std::string_view trimmed(std::string_view text);

/// Takes the first line off a text; lines end with LF, CR LF or CR.
std::string_view next_line(std::string_view& text);

/// The number that the whole field is: one too large is infinite, one too small 0. With
/// `decimal_comma` a comma is a decimal point.
std::optional<double> number_from(std::string_view field, bool decimal_comma = false);

/// The place of an error: "PLACE:LINE".
std::string at_line(const std::string& place, int line_number);

}  // namespace glare
