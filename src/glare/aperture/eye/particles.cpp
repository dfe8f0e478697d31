#include "glare/aperture/eye/particles.h"

#include <cmath>
#include <numbers>
#include <string>

#include "glare/base/error.h"
#include "glare/base/range_check.h"

namespace glare {

namespace {

constexpr double max_area_share = 0.3;

void require_valid(const std::string& medium, const MediumParticles& p) {
  const std::string begin = "eye: " + medium + ".";
  require_in_range(begin + "number_per_mm2", p.number_per_mm2, 0, 20000);
  require_in_range(begin + "diameter_um", p.diameter_um, 0.2, 200);
  require_in_range(begin + "diameter_spread", p.diameter_spread, 0, 0.6);
  require_in_range(begin + "drift_mm_per_s", p.drift_mm_per_s, 0, 1);
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
  require_valid("cornea", p.cornea);
  require_valid("lens", p.lens);
  require_valid("vitreous", p.vitreous);
  const double share = area_share(p.cornea) + area_share(p.lens) + area_share(p.vitreous);
  if (share > max_area_share)
    throw OptionError("eye: the particles cover " + std::to_string(100 * share) +
                      " % of the pupil's plane, expected 30 % or less");
}

}  // namespace glare
