#include "glare/base/text_fields.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace glare {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\v\f\r\n";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string_view next_line(std::string_view& text) {
  const auto end = text.find_first_of("\n\r");
  const std::string_view line = text.substr(0, end);
  if (end == std::string_view::npos)
    text = {};
  else
    text.remove_prefix(end + (text.substr(end).starts_with("\r\n") ? 2 : 1));
  return line;
}

std::optional<double> number_from(std::string_view field, bool decimal_comma) {
  std::string text(field);
  if (decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
  const char* begin = text.c_str();
  const char* const end = begin + text.size();
  if (end - begin > 1 && *begin == '+' && begin[1] != '-') ++begin;
  double number = 0;
  const auto [stop, error] = std::from_chars(begin, end, number);
  if (stop != end || begin == end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) number = std::strtod(begin, nullptr);
  return number;
}

std::string at_line(const std::string& place, int line_number) {
  return place + ":" + std::to_string(line_number);
}

}  // namespace glare
