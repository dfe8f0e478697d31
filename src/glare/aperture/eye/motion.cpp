#include "glare/aperture/eye/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glare/aperture/eye/random.h"

namespace glare {

namespace {

constexpr double kMostUnrest = 3;  // Root mean squares.

/// Of root mean square 1 over a long time, 0 at time 0.
double unrest(std::uint64_t seed, double time_s) {
  constexpr int waves = 32;
  constexpr double slowest_hz = 0.05, corner_hz = 0.5, fastest_hz = 2;
  SplitMix random = random_for(seed, EyePart::hippus);
  double sum = 0, power = 0;
  for (int k = 0; k < waves; ++k) {
    const double place = (k + random.between(0, 1)) / waves;
    const double frequency_hz = slowest_hz * std::pow(fastest_hz / slowest_hz, place);
    const double weight = std::min(1.0, std::pow(corner_hz / frequency_hz, 2));
    const double sign = random.between(-1, 1) < 0 ? -1 : 1;
    sum += sign * weight * std::sin(2 * std::numbers::pi * frequency_hz * time_s);
    power += weight * weight / 2;
  }
  return limited(sum / std::sqrt(power), kMostUnrest);
}

/// From 0 to 1, with no speed at both ends.
double eased(double x) { return 0.5 - 0.5 * std::cos(std::numbers::pi * std::clamp(x, 0.0, 1.0)); }

}  // namespace

double pupil_diameter_at_mm(const EyeParameters& p, double time_s) {
  if (p.motion.hippus_mm == 0) return p.pupil.diameter_mm;
  return p.pupil.diameter_mm + p.motion.hippus_mm * unrest(p.seed, time_s);
}

double largest_pupil_diameter_mm(const EyeParameters& p) {
  return p.pupil.diameter_mm + kMostUnrest * p.motion.hippus_mm;
}

double lid_closure_at(const EyeParameters& p, double time_s) {
  constexpr double closing_s = 0.1, closed_s = 0.05, opening_s = 0.25;
  if (p.motion.blinks_per_minute == 0) return 0;
  const double period_s = 60 / p.motion.blinks_per_minute;
  const double period = std::floor(time_s / period_s);
  SplitMix random = random_for(p.seed, EyePart::blinks, static_cast<std::uint64_t>(period));
  // At 40 a minute a third of a period, 0.5 s, is left for the last blink.
  const double since_s = time_s - (period + random.between(0.02, 0.67)) * period_s;
  if (since_s <= 0) return 0;
  return eased(since_s / closing_s) * (1 - eased((since_s - closing_s - closed_s) / opening_s));
}

}  // namespace glare
