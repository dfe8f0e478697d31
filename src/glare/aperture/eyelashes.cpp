#include "glare/aperture/eyelashes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace glare {

namespace {

/// SplitMix64 (Steele, Lea, Flood 2014), because the standard library's distributions differ from
/// one implementation to the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  double between(double low, double high) {
    constexpr double per_step = 0x1p-53;
    return low + (high - low) * (static_cast<double>(next() >> 11) * per_step);
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

/// Sets the curve's middle point so that the lash bows sideways by `bow` of its length.
void bow(Eyelash& lash, double bow) {
  const Point along = lash.tip - lash.root;
  lash.bend = 0.5 * (lash.root + lash.tip) + 2 * bow * Point{along.y, -along.x};
}

/// A lash that grows at `side`, -1 to 1 from the pupil's left to its right.
Eyelash free_eyelash(const EyeParameters& p, double side, Random& random) {
  constexpr double lid_radius = 15, lid_clearance = 0.3, rows_depth = 0.8;
  const double radius = p.pupil.diameter_mm / 2;
  const double x = 0.95 * radius * side;
  const double lid = x * x / (2 * lid_radius) - radius - lid_clearance;
  const double turn = 0.45 * side + 0.55 * random.between(-1, 1);
  const double angle = turn * 35 * std::numbers::pi / 180;

  Eyelash lash;
  lash.root = {x, lid - random.between(0, rows_depth)};
  const double reach = 0.5 * p.pupil.diameter_mm * random.between(0.7, 1.15);
  const double length = std::max(reach - radius - lash.root.y, 0.0);
  lash.tip = lash.root + length * Point{std::sin(angle), std::cos(angle)};
  lash.root_width = p.upper_lashes.root_width_mm * random.between(0.67, 1);
  bow(lash, random.between(-0.05, 0.05) + 0.02 * side);
  return lash;
}

/// Pulls the tip of `lash` to its neighbour's, as tears and mascara do.
void clump(Eyelash& lash, const Eyelash& neighbour, Random& random) {
  const Point beside{random.between(-0.2, 0.2), random.between(-0.5, 0.3)};
  lash.tip = neighbour.tip + beside;
  bow(lash, random.between(-0.04, 0.04));
}

}  // namespace

std::vector<Eyelash> eyelashes(const EyeParameters& p) {
  constexpr double clumped_share = 0.2;
  Random random(p.seed);
  std::vector<Eyelash> lashes;
  for (int i = 0; i < p.upper_lashes.count; ++i) {
    const double place = i + random.between(0, 1);
    lashes.push_back(free_eyelash(p, 2 * place / p.upper_lashes.count - 1, random));
    const bool clumped = random.between(0, 1) < clumped_share;
    if (clumped && i > 0) clump(lashes[i], lashes[i - 1], random);
  }
  return lashes;
}

}  // namespace glare
