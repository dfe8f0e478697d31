#include "street.h"

#include <cstdint>
#include <numbers>

namespace headlamp {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Vec3 kHorizon{11, 13, 18}, kZenith{5, 9, 17}, kAfterglow{13, 6, 1};  // cd/m^2
constexpr Vec3 kHaze{14, 12, 11};
constexpr Vec3 kRoadReflectance{0.075, 0.073, 0.070}, kGrassReflectance{0.035, 0.05, 0.02};
constexpr double kRoadLeft = -2.1, kRoadRight = 5.6, kCentreLine = 1.75;  // m
constexpr double kTreesLeft = -9.5, kTreesRight = 13;                     // m

double lattice(std::int32_t x, std::int32_t y) {
  auto h =
      static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ static_cast<std::uint32_t>(y) * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return static_cast<double>(h ^ (h >> 15)) / 4294967295.0;
}

/// Value noise from 0 to 1, of one bump per unit.
double noise(double x, double y) {
  constexpr double kFar = 1e6;  // Beyond, all is alike.
  const double fx = std::clamp(std::floor(x), -kFar, kFar);
  const double fy = std::clamp(std::floor(y), -kFar, kFar);
  const auto i = static_cast<std::int32_t>(fx), j = static_cast<std::int32_t>(fy);
  const double u = smooth_step(0, 1, x - fx), v = smooth_step(0, 1, y - fy);
  return std::lerp(std::lerp(lattice(i, j), lattice(i + 1, j), u),
                   std::lerp(lattice(i, j + 1), lattice(i + 1, j + 1), u), v);
}

double fractal_noise(double x, double y) {
  return 0.5 * noise(x, y) + 0.3 * noise(2.1 * x + 7, 2.1 * y) + 0.2 * noise(4.3 * x, 4.3 * y + 3);
}

Vec3 sky(Vec3 direction) {
  const double elevation = std::asin(std::clamp(direction.y, 0.0, 1.0));
  const double glow = std::exp(-elevation / 0.20);
  return mix(kZenith, kHorizon, glow * (1 - 0.15 * direction.x)) +
         std::exp(-elevation / 0.035) * kAfterglow;
}

Vec3 ground(Vec3 p) {
  const Vec3 light = (1 / kPi) * dusk_illuminance({0, 1, 0});
  const double grain = 0.75 + 0.5 * fractal_noise(1.3 * p.x, 0.35 * p.z);
  if (p.x < kRoadLeft || p.x > kRoadRight)
    return (0.5 + fractal_noise(1.1 * p.x, 0.4 * p.z)) * (kGrassReflectance * light);
  const bool edge = std::min(p.x - kRoadLeft, kRoadRight - p.x) < 0.27 &&
                    std::min(p.x - kRoadLeft, kRoadRight - p.x) > 0.15;
  const bool dash = std::abs(p.x - kCentreLine) < 0.07 && std::fmod(p.z + 1, 9) < 3.5;
  return (edge || dash ? 0.42 : grain) *
         ((edge || dash ? Vec3{1, 1, 0.95} : kRoadReflectance) * light);
}

/// A row of trees on a line along the road: its leaves' luminance and whether the ray meets them.
bool meets_trees(Vec3 origin, Vec3 direction, double line, Vec3& luminance) {
  const double reach = (line - origin.x) / direction.x;
  if (!(reach > 0)) return false;
  const Vec3 p = origin + reach * direction;
  if (p.y < 0) return false;
  const double crown =
      3.0 + 3.4 * noise(p.z / 9 + line, line) + 1.5 * fractal_noise(p.z / 2.2, p.y / 1.6);
  if (p.y > crown) return false;
  const double haze = 1 - std::exp(-reach / 1200);
  const Vec3 leaves = (0.25 + 0.6 * fractal_noise(p.z / 3, p.y)) * Vec3{0.5, 0.75, 0.5};
  luminance = mix(leaves, kHaze, haze);
  return true;
}

}  // namespace

Vec3 dusk_illuminance(Vec3 normal) {
  const double up = 0.5 + 0.5 * normal.y;
  const Vec3 west = normalized({-0.75, 0.35, -0.55});
  const double wrapped = std::max(0.0, 0.75 * dot(normal, west) + 0.25);
  return up * Vec3{28, 35, 52} + (1 - up) * Vec3{2.7, 2.7, 2.6} + wrapped * Vec3{30, 23, 17};
}

Vec3 surroundings_luminance(Vec3 direction) {
  const double azimuth = std::atan2(direction.x, direction.z);
  const double elevation = std::asin(std::clamp(direction.y, -1.0, 1.0));
  const double trees = 0.10 + 0.07 * fractal_noise(9 * azimuth, 2);
  const Vec3 road = (1 / kPi) * (kRoadReflectance * dusk_illuminance({0, 1, 0}));
  const Vec3 above =
      mix(Vec3{0.5, 0.6, 0.5}, sky(direction), smooth_step(trees - 0.02, trees + 0.02, elevation));
  return mix(road, above, smooth_step(-0.01, 0.01, elevation));
}

Vec3 street_luminance(Vec3 origin, Vec3 direction) {
  Vec3 luminance;
  if (direction.y < 0) {
    const double reach = -origin.y / direction.y;
    const Vec3 p = origin + reach * direction;
    if (p.x > kTreesLeft && p.x < kTreesRight)
      return mix(ground(p), kHaze, 1 - std::exp(-reach / 1200));
  }
  for (const double line : {kTreesLeft, kTreesRight})
    if (meets_trees(origin, direction, line, luminance)) return luminance;
  return sky(direction);
}

}  // namespace headlamp
