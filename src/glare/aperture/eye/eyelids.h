// The eyelids' margins. Internal.
#pragma once

#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye.h"

namespace glare {

/// Both margins at one time: parabolas that meet at the corners of the eye.
class Eyelids {
 public:
  /// `closure` is how far a blink has closed them, 0 to 1. In a blink the upper lid moves (Doane,
  /// Am. J. Ophthalmol. 89, 1980), down to a little below the lower one's margin.
  Eyelids(const EyelidParameters& parameters, double closure);

  /// From the axis to a corner of the eye.
  static constexpr double kHalfWidth_mm = 14.5;

  /// The margins' y at `x`.
  double upper(double x) const { return -above_ * parabola(x); }
  double lower(double x) const { return below_ * parabola(x); }

  /// What the lids cover of a picture that reaches `reach_mm` from the axis, all ways; only those
  /// that do.
  std::vector<Outline> outlines(double reach_mm) const;

 private:
  static double parabola(double x) { return 1 - x * x / (kHalfWidth_mm * kHalfWidth_mm); }

  double above_, below_;  ///< Of the margins, on the axis.
};

}  // namespace glare
