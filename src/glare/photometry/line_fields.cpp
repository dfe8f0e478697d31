#include "glare/photometry/line_fields.h"

#include <cmath>

#include "glare/base/error.h"

namespace glare::photometry {

std::string LineFields::text(const char* what) { return readable(next(what)); }

double LineFields::number(const char* what, double low, double high) {
  return checked(next(what), what, low, high);
}

double LineFields::optional_number(const char* what) {
  constexpr double kLarge = 1e12;  // Beyond anything real.
  const std::string_view field = next(what);
  return field.empty() ? 0 : checked(field, what, -kLarge, kLarge);
}

int LineFields::whole_number(const char* what, int low, int high) {
  const double value = number(what, low, high);
  if (value != std::floor(value))
    throw InputError(here(),
                     std::string(what) + " is " + text_of(value) + "; a whole number was expected");
  return static_cast<int>(value);
}

std::vector<double> LineFields::angles_deg(const char* what, int count, double last_deg) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    angles.push_back(number(what, 0, last_deg));
    if (i > 0 && angles.back() <= angles[angles.size() - 2])
      throw InputError(here(), std::string(what) + " is " + text_of(angles.back()) + " after " +
                                   text_of(angles[angles.size() - 2]) + "; they must ascend");
  }
  return angles;
}

void LineFields::require_end(std::vector<std::string>& warnings) {
  while (const auto line = lines_.next()) {
    const std::string_view field = trimmed(*line);
    if (field.empty()) continue;
    if (finite_number_from(field, true))
      throw InputError(here(), quoted(field) +
                                   " is left over after the last intensity; the counts of angles "
                                   "or the symmetry don't match what is there");
    warnings.push_back("line " + std::to_string(lines_.number()) + ": " + quoted(field) +
                       " and what follows it, after the last intensity, is ignored");
    return;
  }
}

std::string_view LineFields::next(const char* what) {
  const auto line = lines_.next();
  if (!line) throw InputError(here(), "the file ends before " + std::string(what));
  return trimmed(*line);
}

double LineFields::checked(std::string_view field, const char* what, double low,
                           double high) const {
  const auto value = finite_number_from(field, true);
  if (!value)
    throw InputError(here(),
                     (field.empty() ? "the line is empty" : quoted(field) + " is no number") +
                         "; expected " + what);
  if (*value < low || *value > high)
    throw InputError(here(), std::string(what) + " is " + text_of(*value) + "; expected " +
                                 text_of(low) + " to " + text_of(high));
  return *value;
}

}  // namespace glare::photometry
