// The first lines of an LM-63 file, of texts. Internal.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glare/photometry/text_reading.h"

namespace glare::photometry {

struct IesHeader {
  std::string version;  ///< The version line; "" where there is none.
  int year = 1986;      ///< Of the standard: 1986, 1991, 1995, 2002 or 2019.
  std::string tilt;     ///< What TILT= says.
  std::vector<std::pair<std::string, std::string>> keywords;  ///< As in `PhotometricFileInfo`.
};

/// What follows TILT=, where the line is that.
std::optional<std::string_view> tilt_value(std::string_view line);

/// Reads all up to the line TILT=, with it. Throws `InputError` where there is none.
IesHeader ies_header_from(Lines& lines, const std::string& place,
                          std::vector<std::string>& warnings);

}  // namespace glare::photometry
