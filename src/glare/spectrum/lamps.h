// Lamps: relative spectral power distributions, built in or by temperature.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glare/spectrum/spectrum.h"

namespace glare {

/// A lamp that is built in: a table of CIE 015:2018 (data/lamps/README.md gives each source).
struct BuiltInLamp {
  std::string name;         ///< As the CIE writes it: "A", "FL11", "LED-B3".
  std::string alias;        ///< Another name for it ("hid"), or empty.
  std::string description;  ///< What it stands for.
};

/// Every built-in lamp, in the CIE's order.
std::vector<BuiltInLamp> built_in_lamps();

/// A lamp by its name, an alias (`halogen`, `hid`, `led`), or as a black body ("blackbody:3200", in
/// kelvin). Upper and lower case are the same, and so are "-" and "_". Nothing where no lamp has
/// the name; `OptionError` for a black body outside 500 to 100000 K or with no number.
std::optional<Spectrum> find_lamp(std::string_view name);

/// Relative spectral power of a black body at a temperature in kelvin, 500 to 100000, 300 to 830 nm
/// at 1 nm, 1 at its largest (Planck's law; c2 = 1.4388e-2 m K as in CIE 015:2018, 4.1.1).
Spectrum blackbody(double temperature_k);

}  // namespace glare
