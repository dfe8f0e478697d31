// Round numbers for axes: 1, 2 and 5 times powers of ten.
#pragma once

#include <cmath>
#include <vector>

namespace glare::tool {

/// Those from `least` to `most`, both above 0, descending.
inline std::vector<double> round_numbers(double least, double most) {
  std::vector<double> numbers;
  for (int decade = static_cast<int>(std::floor(std::log10(most))); decade >= -320; --decade)
    for (const double digit : {5.0, 2.0, 1.0}) {
      const double number = digit * std::pow(10.0, decade);
      if (number < least) return numbers;
      if (number <= most) numbers.push_back(number);
    }
  return numbers;
}

/// The step that divides a length, above 0, into at most that many parts.
inline double round_step(double length, int most_parts) {
  const double least = length / most_parts;
  return round_numbers(least, 10 * least).back();
}

}  // namespace glare::tool
