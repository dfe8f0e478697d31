// What a luminous intensity distribution amounts to: its flux, its peak, the widths of its beam.
#pragma once

#include <optional>

#include "glare/photometry/luminous_intensity.h"

namespace glare {

/// The luminous flux in lumen: the integral of the intensity over the directions that were
/// measured, each with its solid angle, cos V dV dH (type A), cos H dH dV (type B), sin gamma
/// dgamma dC (type C).
///
/// It is the exact integral of the distribution as it is interpolated, so that resampling keeps it.
/// Laboratories sum zones instead: a zone's solid angle times the intensity in its middle, which is
/// either measured or the mean of its ends. In steps of 1 to 2.5 degrees that is the same to some
/// tenths of a per cent (docs/photometry.md).
double luminous_flux_lm(const LuminousIntensityDistribution& distribution);

struct PeakIntensity {
  double candela = 0;
  double horizontal_deg = 0, vertical_deg = 0;  ///< H and V; C and gamma for type C.
};

/// The largest intensity, which is at a measured direction. Of equal ones the first is told, in the
/// order of V (gamma) and then H (C).
PeakIntensity peak_intensity(const LuminousIntensityDistribution& distribution);

/// The full widths of the beam in degrees, from where the intensity first falls to a share of its
/// peak on one side to where it does on the other, linear between measured angles. Nothing where it
/// doesn't fall so far within what was measured, or all around.
struct BeamWidths {
  /// Type A and B: along H through the peak, at the peak's V. Type C: along the great circle
  /// through the peak that is perpendicular to its C-plane.
  std::optional<double> horizontal_deg;
  /// Type A and B: along V through the peak, at the peak's H. Type C: along gamma in the peak's
  /// plane C and its opposite, C + 180.
  std::optional<double> vertical_deg;
};

/// `share` of the peak, above 0 and below 1: 0.5 for the beam's width, 0.1 for the field's. Both
/// are nothing for a distribution that is 0 everywhere.
BeamWidths beam_widths(const LuminousIntensityDistribution& distribution, double share = 0.5);

}  // namespace glare
