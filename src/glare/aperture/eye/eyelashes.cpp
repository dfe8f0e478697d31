#include "glare/aperture/eye/eyelashes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "glare/aperture/eye/random.h"

namespace glare {

namespace {

/// A lash's axis is an arc in a vertical plane. At the share s of its length it has the angle
/// droop - s curl to the line of sight, which is turned sideways by `azimuth`.
struct Lash {
  Point root;
  double length, droop, curl, azimuth, root_radius, tip_radius;
  double inward;    ///< Towards the pupil: 1 is down, -1 is up.
  double pull = 0;  ///< Of the tuft.
  Point to_tuft{};  ///< From the tip as it would be alone.

  /// Integrals of sin and cos of the angle over the length, up to the share `s`.
  double across(double s) const {
    if (std::abs(curl) < 1e-6) return s * length * std::sin(droop);
    return length / curl * (std::cos(droop - s * curl) - std::cos(droop));
  }
  double along(double s) const {
    if (std::abs(curl) < 1e-6) return s * length * std::cos(droop);
    return length / curl * (std::sin(droop) - std::sin(droop - s * curl));
  }

  Point at(double s) const {
    const Point free{along(s) * std::sin(azimuth), inward * across(s)};
    return root + free + pull * s * s * to_tuft;
  }
  double radius(double s) const { return root_radius + s * (tip_radius - root_radius); }
};

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The lash number `index`, alone. The ranges around the parameters are choices.
Lash free_lash(const EyelashParameters& p, Lid lid, const Eyelids& lids, SplitMix& random,
               int index) {
  constexpr double rows_depth_mm = 0.8;
  Lash lash;
  lash.inward = lid == Lid::upper ? 1 : -1;
  const double place = 2 * (index + random.between(0, 1)) / p.count - 1;
  const double x = Eyelids::kHalfWidth_mm * place;
  const double margin = lid == Lid::upper ? lids.upper(x) : lids.lower(x);
  lash.root = {x, margin - lash.inward * random.between(0, rows_depth_mm)};
  lash.length = p.length_mm * (1 - 0.4 * place * place) * random.between(0.7, 1);
  lash.droop = radians(p.droop_deg + p.scatter_deg * random.normal());
  lash.curl = radians(p.curl_deg) * random.between(0.7, 1.3);
  lash.azimuth = radians(p.fan_deg * place + p.scatter_deg * random.normal());
  lash.root_radius = p.root_width_mm / 2 * random.between(0.67, 1);
  lash.tip_radius = p.tip_share * lash.root_radius;
  return lash;
}

/// Draws the tips of neighbours, 2 to 6 at a time, towards their mean.
void gather(std::vector<Lash>& lashes, double clumping, SplitMix& random) {
  for (std::size_t first = 0; first < lashes.size();) {
    const auto count = static_cast<std::size_t>(random.between(2, 7));
    const std::size_t last = std::min(first + count, lashes.size());
    Point middle;
    for (std::size_t i = first; i < last; ++i)
      middle = middle + 1.0 / static_cast<double>(last - first) * lashes[i].at(1);
    for (std::size_t i = first; i < last; ++i) {
      lashes[i].to_tuft = middle - lashes[i].at(1);
      lashes[i].pull = clumping * random.between(0.5, 1);
    }
    first = last;
  }
}

/// The lash from the share `from` of its length to the share `to`.
Outline drawn(const Lash& lash, double from, double to) {
  constexpr int pieces = 96;  // A lash 10 mm long, bowed by 7 %: sagittas of some 0.1 um.
  constexpr int cap_pieces = 8;
  std::vector<Point> near_side, far_side;
  Point along;
  for (int i = 0; i <= pieces; ++i) {
    const double step = (to - from) / pieces, s = from + i * step;
    const Point chord = lash.at(s + 0.5 * step) - lash.at(s - 0.5 * step);
    const double length = std::hypot(chord.x, chord.y);
    if (length > 0) along = 1 / length * chord;
    const Point side = lash.radius(s) * Point{-along.y, along.x};
    near_side.push_back(lash.at(s) - side);
    far_side.push_back(lash.at(s) + side);
  }
  for (int i = 1; i < cap_pieces; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / cap_pieces - 0.5);
    const Point outward = std::cos(angle) * along + std::sin(angle) * Point{-along.y, along.x};
    near_side.push_back(lash.at(to) + lash.radius(to) * outward);
  }
  near_side.insert(near_side.end(), far_side.rbegin(), far_side.rend());
  return Outline(near_side);
}

}  // namespace

std::vector<Outline> eyelashes(const EyelashParameters& p, Lid lid, const Eyelids& lids,
                               std::uint64_t seed) {
  const EyePart part = lid == Lid::upper ? EyePart::upper_lashes : EyePart::lower_lashes;
  std::vector<Lash> lashes;
  for (int i = 0; i < p.count; ++i) {
    SplitMix random = random_for(seed, part, 1 + static_cast<std::uint64_t>(i));
    lashes.push_back(free_lash(p, lid, lids, random, i));
  }
  SplitMix random = random_for(seed, part);
  gather(lashes, p.clumping, random);

  std::vector<Outline> outlines;
  for (const Lash& lash : lashes) {
    const double turn = lash.curl > 0 ? lash.droop / lash.curl : 0;  // Where it points at the lamp.
    if (turn > 0.02 && turn < 0.98) {
      outlines.push_back(drawn(lash, 0, turn));
      outlines.push_back(drawn(lash, turn, 1));
    } else {
      outlines.push_back(drawn(lash, 0, 1));
    }
  }
  return outlines;
}

}  // namespace glare
