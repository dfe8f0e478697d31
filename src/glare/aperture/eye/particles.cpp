#include "glare/aperture/eye/particles.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "glare/base/error.h"

namespace glare {

namespace {

constexpr double max_area_share = 0.3;

void require_in_range(const char* medium, const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  char text[160];
  std::snprintf(text, sizeof text, "eye: %s.%s is %g, expected %g to %g", medium, name, value, low,
                high);
  throw OptionError(text);
}

void require_in_range(const char* medium, const MediumParticles& p) {
  require_in_range(medium, "number_per_mm2", p.number_per_mm2, 0, 20000);
  require_in_range(medium, "diameter_um", p.diameter_um, 0.2, 200);
  require_in_range(medium, "diameter_spread", p.diameter_spread, 0, 0.6);
  require_in_range(medium, "drift_mm_per_s", p.drift_mm_per_s, 0, 1);
}

/// Mean of exp(k spread z), where z is the sum of 12 uniform deviates between -0.5 and 0.5.
double mean_of_power(double k, double spread) {
  const double half = 0.5 * k * spread;
  return half < 1e-6 ? 1 : std::pow(std::sinh(half) / half, 12);
}

}  // namespace

double particles_per_mm2(double volume_fraction, double thickness_mm, double diameter_um,
                         double diameter_spread) {
  const double diameter = diameter_um * 1e-3;
  const double mean_volume =
      std::numbers::pi / 6 * diameter * diameter * diameter * mean_of_power(3, diameter_spread);
  return volume_fraction * thickness_mm / mean_volume;
}

double area_share(const MediumParticles& p) {
  const double diameter = p.diameter_um * 1e-3;
  return p.number_per_mm2 * std::numbers::pi / 4 * diameter * diameter *
         mean_of_power(2, p.diameter_spread);
}

void require_valid(const ParticleParameters& p) {
  require_in_range("cornea", p.cornea);
  require_in_range("lens", p.lens);
  require_in_range("vitreous", p.vitreous);
  const double share = area_share(p.cornea) + area_share(p.lens) + area_share(p.vitreous);
  if (share > max_area_share)
    throw OptionError("eye: the particles cover " + std::to_string(100 * share) +
                      " % of the pupil's plane, expected 30 % or less");
}

}  // namespace glare
