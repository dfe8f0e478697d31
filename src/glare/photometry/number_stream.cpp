#include "glare/photometry/number_stream.h"

#include <cmath>

namespace glare::photometry {

NumberStream::Field NumberStream::next() {
  while (true) {
    line_ = line_.substr(std::min(line_.find_first_not_of(" \t\v\f"), line_.size()));
    if (line_.empty()) {
      const auto line = lines_.next();
      if (!line) return {{}, lines_.number(), false};
      line_ = *line;
      line_is_fresh_ = true;
    } else if (line_.front() == ',') {
      if (after_comma_)
        throw InputError(at_line(place_, lines_.number()), "there is nothing between two commas");
      after_comma_ = true;
      line_.remove_prefix(1);
    } else {
      break;
    }
  }
  const auto end = std::min(line_.find_first_of(" \t\v\f,"), line_.size());
  const Field field{line_.substr(0, end), lines_.number(), line_is_fresh_};
  line_.remove_prefix(end);
  line_is_fresh_ = false;
  after_comma_ = false;
  return field;
}

double NumberStream::number_within(const char* what, double low, double high) {
  const double value = number([&] { return what; });
  if (value < low || value > high)
    throw InputError(here(), std::string(what) + " is " + text_of(value) + "; expected " +
                                 text_of(low) + " to " + text_of(high));
  return value;
}

int NumberStream::whole_number(const char* what, int low, int high) {
  const double value = number_within(what, low, high);
  if (value != std::floor(value))
    throw InputError(here(),
                     std::string(what) + " is " + text_of(value) + "; a whole number was expected");
  return static_cast<int>(value);
}

}  // namespace glare::photometry
