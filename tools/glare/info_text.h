// What the commands that tell of a file write as text.
#pragma once

#include <cstddef>
#include <string>

namespace glare::tool {

/// The text with spaces for control characters (those of one byte, and U+0080 to U+009F), so that a
/// file can't move a terminal's cursor.
std::string printable(std::string text);

/// The text and spaces up to a width.
std::string padded(std::string text, std::size_t width);

/// "label                 value", printable.
std::string line(const char* label, const std::string& value);

/// With that many significant digits.
std::string number(double value, int digits = 6);

std::string fixed(double value, int decimals);

}  // namespace glare::tool
