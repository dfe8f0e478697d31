// The CIE standard observers: what an eye makes of light of each wavelength.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "glare/color/matrix.h"
#include "glare/spectrum/spectrum.h"

namespace glare {

/// Colour matching functions, dimensionless, all three over the same wavelengths.
struct ColorMatchingFunctions {
  std::string name;
  Spectrum x_bar;
  Spectrum y_bar;
  Spectrum z_bar;

  WavelengthRange range() const { return y_bar.range(); }
};

/// Names of the built-in observers: "cie1931-2deg", "cie1964-10deg" (CIE 018:2019), "cie2015-2deg"
/// and "cie2015-10deg" (CIE 170-2:2015), each at 1 nm.
std::vector<std::string> observer_names();

/// The colour matching functions of a built-in observer. Throws `OptionError` for another name.
const ColorMatchingFunctions& color_matching_functions(std::string_view observer_name);

/// Tristimulus values of a lamp at luminance Y = 1: the integrals of S x̄, S ȳ and S z̄ over the
/// range, divided by that of S ȳ; exact for functions linear between their samples. Throws
/// `InputError` where the lamp has no light that the observer sees.
Xyz xyz_from_spectrum(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                      const WavelengthRange& range);

/// The integral of S ȳ over the range, in nm times the lamp's unit.
double luminous_integral(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                         const WavelengthRange& range);

/// How wide the light is that the observer sees of a lamp, in nm: (integral of S ȳ)^2 / integral of
/// (S ȳ)^2 over the range, by Simpson's rule between the samples. A single line's is about its own
/// width, daylight's some 100 nm. Not a number where the lamp has no light there.
double effective_width_nm(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                          const WavelengthRange& range);

/// Share of the observer's luminous sensitivity (the integral of ȳ over `range`) that lies outside
/// the wavelengths which the lamp's table covers; 0 to 1.
double share_of_sensitivity_missed(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                                   const WavelengthRange& range);

}  // namespace glare
