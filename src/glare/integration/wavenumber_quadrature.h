// The integral over wavelength as a weighted sum over wavenumbers. Internal.
#pragma once

#include <array>
#include <vector>

#include "glare/spectrum/observer.h"
#include "glare/spectrum/spectrum.h"

namespace glare {

/// XYZ = sum over k of weights[k] I(theta wavenumber_per_mm[k]) stands for
///   integral of I(theta / lambda) / lambda^2 S (x̄, ȳ, z̄) dlambda / integral of S ȳ dlambda.
struct WavenumberQuadrature {
  std::vector<double> wavenumbers_per_mm;  ///< 1 / lambda, ascending, evenly spaced.
  std::vector<std::array<float, 3>> weights;
};

/// A quadrature with `nodes` >= 4 wavenumbers over the range. I is taken as the cubic through its
/// four nearest nodes, and each such cubic is integrated against the spectra exactly
/// (Gauss-Legendre between all their samples), so no line of a lamp falls between nodes. It is
/// exact where I(theta nu) is a cubic of nu over each step; it needs three or more a cycle of I.
WavenumberQuadrature wavenumber_quadrature(const Spectrum& lamp,
                                           const ColorMatchingFunctions& observer,
                                           const WavelengthRange& range, int nodes);

}  // namespace glare
