// Photometric files of Europe's lighting industry: EULUMDAT, "*.ldt".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "glare/photometry/photometric_data.h"

namespace glare {

struct EulumdatOptions {
  /// Which of the file's sets of lamps, from 1; nothing: the first one, with a warning where there
  /// are several.
  std::optional<int> lamp_set = {};
};

/// Whether the lines that tell counts and symmetry in EULUMDAT are such numbers here.
bool looks_like_eulumdat(std::string_view text);

/// Reads EULUMDAT (Stockmar 1990): one field a line, type C, symmetry indicators 0 to 4, which are
/// unfolded. Lines may end in any way, numbers have a decimal point or comma, texts are Latin-1 or
/// UTF-8 and may be empty, as may numbers that Glare makes no use of.
///
/// Intensities are the file's candela per 1000 lm, times the conversion factor, times the total
/// flux of the set of lamps / 1000 (sets are alternatives, of which a luminaire has one at a time).
/// The light output ratio is in the intensities already: the luminaire's flux, `stated_flux_lm`, is
/// this ratio of the lamps' flux. A negative number of lamps tells absolute photometry: their total
/// flux is the luminaire's (Ashdown and DIAL 2009), and intensities are made in the same way.
///
/// Warned of: several sets of lamps, angles that aren't in the steps that the file tells (its
/// angles are taken), a conversion factor of 0 (1 is taken), text after the last number.
///
/// Throws `InputError`, whose place is `place`:LINE, where the file ends too early, a number is
/// missing, isn't one, out of its range or out of order, the planes aren't those of the symmetry,
/// or a number is left over; `OptionError` for a set of lamps that isn't there.
PhotometricData parse_eulumdat(std::string_view text, const std::string& place,
                               const EulumdatOptions& options = {});

}  // namespace glare
