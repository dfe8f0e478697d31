// A wavefront error from a table in a file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "glare/wavefront/aberrations.h"

namespace glare {

/// Reads a text of one line `pupil_diameter_mm,D` and then rows of `j,coefficient_um` (OSA/ANSI
/// single index) or, all of them, `n,m,coefficient_um`. Passed over: empty lines, comments (from #
/// to the end of the line), and one header line of words before the first row. Throws `InputError`
/// with `place` and line for anything else, an index that is none or stands there twice, and
/// numbers outside the ranges of `ZernikeWavefront`.
ZernikeWavefront parse_zernike_table(std::string_view text, const std::string& place);

/// The same from a file of at most 1 MB.
ZernikeWavefront read_zernike_file(const std::filesystem::path& path);

}  // namespace glare
