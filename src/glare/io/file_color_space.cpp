#include "glare/io/file_color_space.h"

#include <cmath>
#include <cstddef>

#include "glare/base/error.h"
#include "glare/io/built_in_color_spaces.h"
#include "glare/io/image/image_header.h"

namespace glare {

namespace {

bool are_the_same(const FileChromaticities& a, const FileChromaticities& b) {
  // Files have five decimals at most, or a float's digits.
  constexpr double tolerance = 1e-5;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!(std::abs(a[k].x - b[k].x) <= tolerance && std::abs(a[k].y - b[k].y) <= tolerance))
      return false;
  return true;
}

}  // namespace

FileChromaticities chromaticities_of(const RgbColorSpace& space) {
  const auto [red, green, blue] = space.primaries();
  return {red, green, blue, chromaticity(space.white_xyz())};
}

RgbColorSpace color_space_with(const FileChromaticities& c, const std::string& name) try {
  for (const RgbColorSpace& space : built_in_color_spaces())
    if (!space.is_xyz() && (name.empty() || name == space.name()) &&
        are_the_same(c, chromaticities_of(space)))
      return space;
  return {name.empty() ? "custom" : name, {c[0], c[1], c[2]}, xyz_from_chromaticity(c[3])};
} catch (const InputError& error) {
  throw image_io::BadImage("the attribute chromaticities: " + error.message());
}

}  // namespace glare
