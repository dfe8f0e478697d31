// Numbers that must lie in a range. Internal.
#pragma once

#include <cstdio>
#include <string>

#include "glare/base/error.h"

namespace glare {

/// Throws `OptionError`, "WHAT is VALUE, expected LOW to HIGH", for a value outside the range or
/// not a number.
inline void require_in_range(const std::string& what, double value, double low, double high) {
  if (value >= low && value <= high) return;
  char text[120];
  std::snprintf(text, sizeof text, " is %g, expected %g to %g", value, low, high);
  throw OptionError(what + text);
}

}  // namespace glare
