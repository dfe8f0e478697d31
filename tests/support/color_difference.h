// How far apart two colours look: CIE L*a*b* and CIEDE2000, for tests.
#pragma once

#include "glare/color/matrix.h"

namespace glare::test {

struct Lab {
  double L = 0;
  double a = 0;
  double b = 0;
};

/// CIE 1976 L*a*b* (CIE 15:2004, 8.2.1) under the given white. A value below 0 stays on the
/// linear part of the curve.
Lab lab_from_xyz(const Xyz& xyz, const Xyz& white);

/// CIEDE2000 with k_L = k_C = k_H = 1: Sharma, Wu and Dalal, "The CIEDE2000 color-difference
/// formula: implementation notes, supplementary test data, and mathematical observations", 2005.
double ciede2000(const Lab& a, const Lab& b);

/// CIEDE2000 of two colours after both are scaled by the one factor that gives `reference` the
/// luminance of `white` (L* = 100). An error of luminance counts as well as one of chromaticity.
/// Throws `std::invalid_argument` unless the reference's luminance is above 0.
double ciede2000_at_own_luminance(const Xyz& color, const Xyz& reference, const Xyz& white);

}  // namespace glare::test
