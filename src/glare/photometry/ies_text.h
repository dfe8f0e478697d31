// Photometric files of the Illuminating Engineering Society, ANSI/IES LM-63.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "glare/photometry/photometric_data.h"

namespace glare {

struct IesOptions {
  /// The text of the file that TILT= names, or nothing where it can't be had; a warning then.
  std::function<std::optional<std::string>(const std::string& name)> tilt_file = {};
};

/// Whether the text has a line TILT=, as all of LM-63 do.
bool looks_like_ies(std::string_view text);

/// Reads LM-63 of 1986 (no version line), 1991, 1995, 2002 and 2019, types A, B and C, with all the
/// symmetries of the standard, which are unfolded.
///
/// Taken as it comes: a byte order mark, any line ends, Ctrl-Z, Latin-1, version lines and TILT= in
/// other spellings, numbers on as many lines as you like, parted by blanks, tabs or commas. Warned
/// of, and taken: an unknown version, text after the last number, an intensity row that doesn't
/// begin on a line of its own while the first one does, a type C circle that ends one step before
/// 360 (closed), angles of type C that don't begin and end at 0, 90 or 180, and those of type A and
/// B whose V begins at 0.
///
/// Intensities are the file's numbers times the candela multiplier and the ballast factor, and
/// before 1995 also times the ballast-lamp photometric factor: from 1995 on this number is kept for
/// future use, in 2019 it tells how the file was made. Lumens per lamp are -1 in absolute
/// photometry. TILT multipliers are read and checked, and kept in `info.tilt`: they are for tilted
/// luminaires and apply to no intensity here.
///
/// Throws `InputError`, whose place is `place`:LINE, where something is missing, is no number, out
/// of its range or out of order, a count is not what is there, or a number is left over; nothing is
/// ever shifted to make it fit.
PhotometricData parse_ies(std::string_view text, const std::string& place,
                          const IesOptions& options = {});

}  // namespace glare
