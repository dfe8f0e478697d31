// Reading a spectrum from the text of a table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glare/spectrum/spectrum.h"

namespace glare {

/// Columns of numbers, in the order of the text.
struct NumberTable {
  std::vector<std::vector<double>> rows;
  std::vector<int> line_numbers;  ///< Where each row stands in the text, from 1.
};

/// Reads rows of `columns` numbers, parted by commas, semicolons, tabs or blanks. Passed over: a
/// byte order mark, empty lines, comments (from `#` to the end of the line), further columns, and
/// lines of words before the first row (the header). Where semicolons or tabs part the columns, a
/// comma is a decimal sign. Throws `InputError` with `place` and line number for a row that is too
/// short or has something else than numbers.
NumberTable parse_number_table(std::string_view text, const std::string& place, int columns);

/// A lamp's relative spectral power from the text of a table "wavelength_nm, power". Rows may stand
/// in any order and at any step. Throws `InputError` with `place`, and the line where there is one,
/// for text in a number, fewer than two rows, a wavelength that is negative or stands there twice,
/// negative power, and power that is 0 everywhere.
Spectrum parse_lamp_table(std::string_view text, const std::string& place);

}  // namespace glare
