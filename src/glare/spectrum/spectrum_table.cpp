#include "glare/spectrum/spectrum_table.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "glare/base/error.h"
#include "glare/base/text_fields.h"

namespace glare {

namespace {

std::string_view without_quotes(std::string_view text) {
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
    return trimmed(text.substr(1, text.size() - 2));
  return text;
}

/// The column separator of a line: the strongest of semicolon, tab and comma in it, else a blank.
char separator_of(std::string_view line) {
  for (const char separator : {';', '\t', ','})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  while (true) {
    const auto end = line.find_first_of(separator == ' ' ? " \t" : std::string_view(&separator, 1));
    fields.push_back(without_quotes(trimmed(line.substr(0, end))));
    if (end == std::string_view::npos) return fields;
    line = line.substr(end + 1);
    if (separator == ' ') line = trimmed(line);
  }
}

/// The numbers of one line; nothing where the line is no row of numbers.
std::optional<std::vector<double>> numbers_of(const std::vector<std::string_view>& fields,
                                              int columns, bool decimal_comma) {
  std::vector<double> numbers;
  for (int column = 0; column < columns; ++column) {
    const auto number = number_from(fields[column], decimal_comma);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

bool has_a_number(const std::vector<std::string_view>& fields, bool decimal_comma) {
  return std::any_of(fields.begin(), fields.end(), [&](std::string_view field) {
    return number_from(field, decimal_comma).has_value();
  });
}

[[noreturn]] void throw_not_numbers(const std::string& place, std::string_view line, int columns) {
  throw InputError(place, "\"" + std::string(line.substr(0, 60)) + "\" isn't a row of " +
                              std::to_string(columns) + " numbers");
}

}  // namespace

NumberTable parse_number_table(std::string_view text, const std::string& place, int columns) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  NumberTable table;
  bool header_allowed = true;
  for (int line_number = 1; !text.empty(); ++line_number) {
    const std::string_view whole = next_line(text);
    const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
    if (line.empty()) continue;
    const char separator = separator_of(line);
    const bool decimal_comma = separator == ';' || separator == '\t';
    const auto fields = split(line, separator);
    const bool wide_enough = fields.size() >= static_cast<std::size_t>(columns);
    const auto numbers = wide_enough ? numbers_of(fields, columns, decimal_comma) : std::nullopt;
    const bool header = !numbers && header_allowed && !has_a_number(fields, decimal_comma);
    if (!numbers && !header) throw_not_numbers(at_line(place, line_number), line, columns);
    if (header) continue;
    header_allowed = false;
    table.rows.push_back(*numbers);
    table.line_numbers.push_back(line_number);
  }
  return table;
}

Spectrum parse_lamp_table(std::string_view text, const std::string& place) {
  const NumberTable table = parse_number_table(text, place, 2);
  if (table.rows.size() < 2)
    throw InputError(place, "has " + std::to_string(table.rows.size()) +
                                " rows of wavelength_nm,power; at least two are needed");
  std::vector<double> wavelengths_nm, power;
  std::unordered_map<double, int> line_of;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::string here = at_line(place, table.line_numbers[i]);
    const double wavelength_nm = table.rows[i][0];
    if (!std::isfinite(wavelength_nm) || wavelength_nm <= 0)
      throw InputError(here, "the wavelength isn't a positive number of nanometres");
    if (!std::isfinite(table.rows[i][1]) || table.rows[i][1] < 0)
      throw InputError(here, "the power is negative or not finite");
    const auto [earlier, is_new] = line_of.emplace(wavelength_nm, table.line_numbers[i]);
    if (!is_new)
      throw InputError(
          here, "the wavelength stands in line " + std::to_string(earlier->second) + " already");
    wavelengths_nm.push_back(wavelength_nm);
    power.push_back(table.rows[i][1]);
  }
  if (*std::max_element(power.begin(), power.end()) == 0)
    throw InputError(place, "the power is 0 at every wavelength");
  return Spectrum(std::move(wavelengths_nm), std::move(power));
}

}  // namespace glare
