#include "glare/scatter/straylight.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "glare/base/error.h"
#include "glare/base/units.h"
#include "glare/scatter/gauss_legendre.h"

namespace glare {

namespace {

constexpr double kLargestAngle_deg = 90;

// The join below 0.1 degrees; docs/scatter.md says why these.
constexpr double kPlateau_deg = 0.075;
constexpr int kSharpness = 12;

double fourth_power(double x) { return x * x * x * x; }

void require_age_and_pigment(double age_years, double pigment) {
  char text[96];
  if (!(age_years >= 0 && age_years <= kOldestStraylight_years)) {
    std::snprintf(text, sizeof text, "an age of %g years; expected 0 to %g", age_years,
                  kOldestStraylight_years);
    throw OptionError(text);
  }
  if (!(pigment >= 0 && pigment <= kPalestStraylight)) {
    std::snprintf(text, sizeof text, "a pigment of %g; expected 0 (very dark) to %g (light blue)",
                  pigment, kPalestStraylight);
    throw OptionError(text);
  }
}

void require_angle(bool valid) {
  if (!valid) throw OptionError("an angle that straylight isn't defined for");
}

double general_equation(double angle_deg, double age_years, double pigment) {
  const double u = 1 / angle_deg;
  return 10 * u * u * u + (5 * u * u + 0.1 * pigment * u) * (1 + fourth_power(age_years / 62.5)) +
         0.0025 * pigment;
}

/// (angle^n + plateau^n)^(1/n).
double softened(double angle_deg) {
  const double larger = std::max(angle_deg, kPlateau_deg);
  const double ratio = std::min(angle_deg, kPlateau_deg) / larger;
  static_assert(kSharpness == 12);
  const double twelfth_power = fourth_power(ratio * ratio * ratio);
  constexpr double kNothing = 1e-14;
  if (twelfth_power < kNothing) return larger;
  return larger * std::pow(1 + twelfth_power, 1.0 / kSharpness);
}

double straylight(const Straylight& eye, double angle_deg) {
  return general_equation(softened(angle_deg), eye.age_years, eye.pigment);
}

}  // namespace

void require_valid(const Straylight& eye) { require_age_and_pigment(eye.age_years, eye.pigment); }

double cie_general_glare(double angle_deg, double age_years, double pigment) {
  require_age_and_pigment(age_years, pigment);
  require_angle(angle_deg > 0);
  return general_equation(angle_deg, age_years, pigment);
}

double straylight_per_steradian(const Straylight& eye, double angle_deg) {
  require_valid(eye);
  require_angle(angle_deg >= 0);
  return straylight(eye, angle_deg);
}

double scattered_energy(const Straylight& eye, double beyond_deg) {
  require_valid(eye);
  require_angle(beyond_deg >= 0);
  const auto ring_density = [&](double angle_deg) {  // 2 pi S sin cos, per degree.
    return std::numbers::pi * straylight(eye, angle_deg) * std::sin(2 * angle_deg * kRadPerDeg) *
           kRadPerDeg;
  };
  // Panels that widen with the angle, and are short against the bend at the plateau's edge.
  constexpr double kRatio = 1.1, kFirst_deg = kPlateau_deg / 16;
  double sum = 0;
  for (double from = beyond_deg; from < kLargestAngle_deg;) {
    const double to = std::min(kLargestAngle_deg, std::max(from * kRatio, from + kFirst_deg));
    for (std::size_t k = 0; k < kGauss4.size(); ++k)
      sum += (to - from) * kGauss4[k].weight *
             ring_density((from + to) / 2 + (to - from) / 2 * kGauss4[k].place);
    from = to;
  }
  return sum;
}

}  // namespace glare
