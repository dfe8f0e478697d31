#include "scene.h"

#include <numbers>

#include "car.h"
#include "street.h"

namespace headlamp {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Vec3 kPaint{0.075, 0.15, 0.25};  // Diffuse reflectance.

/// Schlick's approximation of a clear coat's or a glass's mirroring.
double fresnel(double cosine) {
  return 0.045 + 0.955 * std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5);
}

/// The share of the surroundings that a surface sees, from the distances along its normal.
double openness(Vec3 p, Vec3 normal) {
  double closed = 0;
  for (double step = 0.02, weight = 1; step < 0.5; step *= 2.2, weight *= 0.72)
    closed += weight * std::max(0.0, step - car_distance(p + step * normal)) / step;
  return std::clamp(1 - 0.42 * closed, 0.0, 1.0);
}

Vec3 diffuse(Vec3 reflectance, Vec3 normal) {
  return (1 / kPi) * (reflectance * dusk_illuminance(normal));
}

/// The gaps between bonnet, wings, doors and bumper.
bool in_gap(Vec3 p, Vec3 normal) {
  constexpr double kHalf = 0.0045;
  const double x = std::abs(p.x);
  if (normal.y > 0.5 && p.z > -0.4 && p.z < 0.70)
    return std::abs(x - 0.765 + 0.12 * std::max(p.z, 0.0)) < kHalf ||
           (std::abs(p.z - 0.66 + 0.3 * p.x * p.x) < 1.6 * kHalf && x < 0.70);
  if (p.z > 0.3 && x > 0.45) return std::abs(p.y - 0.575) < kHalf;
  if (p.z < -0.4 && p.y > 0.3 && p.y < 1.0 && p.z > -2.3)
    return std::min({std::abs(p.z + 0.55), std::abs(p.z + 1.68), std::abs(p.y - 0.3)}) < kHalf;
  return false;
}

/// What is seen through a window, in the car's axes: wheel, seats, the rear window.
Vec3 cabin_luminance(Vec3 p, Vec3 direction, Vec3 behind) {
  const auto at = [&](double z) {
    const double reach = (z - p.z) / direction.z;
    return Vec2{p.x + reach * direction.x, p.y + reach * direction.y};
  };
  constexpr Vec3 kTrim{0.35, 0.39, 0.44};
  if (direction.z > -0.3) return kTrim;
  const Vec2 wheel = at(-0.95), seat = at(-1.5), rear = at(-2.75);
  if (std::abs(std::hypot(wheel.x + 0.36, 1.1 * (wheel.y - 0.93)) - 0.18) < 0.014)
    return 0.6 * kTrim;
  const Vec2 side{std::abs(seat.x) - 0.36, seat.y};
  if (rounded_rectangle({side.x, side.y - 1.15}, {0.125, 0.085}, 0.06) < 0 ||
      rounded_rectangle({side.x, side.y - 0.6}, {0.235, 0.42}, 0.12) < 0)
    return 1.5 * kTrim;
  if (rounded_rectangle({rear.x, rear.y - 1.215}, {0.53, 0.13}, 0.07) < 0) return 0.45 * behind;
  return kTrim;
}

/// A lamp's cover over a dark housing with two bowls.
struct LampInside {
  Vec3 normal;  ///< Of what mirrors.
  Vec3 reflectance;
};

LampInside inside_lamp(Vec3 p, Vec3 cover_normal) {
  const double side = p.x < 0 ? -1 : 1;
  for (const Vec2 middle : {kHighBeam, kLowBeam}) {
    constexpr double kRadius = 0.058;
    const double right = std::abs(p.x) - middle.x, up = p.y - middle.y;
    const double share = std::hypot(right, up) / kRadius;
    if (share > 1.08) continue;
    if (share > 0.96) return {{0, 0.3, 0.95}, {0.75, 0.75, 0.75}};
    if (share < 0.42)  // the bulb's cap or a lens
      return {normalized({1.6 * side * right / kRadius, 1.6 * up / kRadius, 1}), {0.35, 0.37, 0.4}};
    return {normalized({-0.75 * side * right / kRadius, -0.75 * up / kRadius, 1}),
            {0.85, 0.85, 0.86}};
  }
  if (std::abs(p.x) > 0.835) return {cover_normal, {0.5, 0.2, 0.03}};
  const double ridge = std::remainder(p.y + 0.1 * std::abs(p.x), 0.02) / 0.02;
  return {normalized(cover_normal + Vec3{0, 0.9 * ridge - 0.5, 0}), {0.10, 0.10, 0.11}};
}

}  // namespace

Scene::Scene(double distance_m, double yaw_deg)
    : distance_(distance_m),
      cosine_(std::cos(yaw_deg * kPi / 180)),
      sine_(std::sin(yaw_deg * kPi / 180)) {}

// The car's right is (-cos, 0, sin) of the viewer's axes, its forward (-sin, 0, -cos).
Vec3 Scene::turned_to_car(Vec3 d) const {
  return {-cosine_ * d.x + sine_ * d.z, d.y, -sine_ * d.x - cosine_ * d.z};
}

Vec3 Scene::turned_to_viewer(Vec3 d) const {
  return {-cosine_ * d.x - sine_ * d.z, d.y, sine_ * d.x - cosine_ * d.z};
}

Vec3 Scene::place_of(Vec3 on_car) const { return turned_to_viewer(on_car) + Vec3{0, 0, distance_}; }

std::optional<Vec3> Scene::on_car(Vec3 origin, Vec3 direction) const {
  const Vec3 start = in_car(origin), along = turned_to_car(direction);
  double enter = 0, leave = 1e30;
  const auto clip = [&](double from, double slope, double low, double high) {
    const double a = (low - from) / slope, b = (high - from) / slope;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  };
  clip(start.x, along.x, kCarLow.x, kCarHigh.x);
  clip(start.y, along.y, kCarLow.y, kCarHigh.y);
  clip(start.z, along.z, kCarLow.z, kCarHigh.z);
  for (int step = 0; step < 200 && enter < leave; ++step) {
    const double distance = car_distance(start + enter * along);
    if (distance < 5e-4) return origin + enter * direction;
    enter += distance;
  }
  return std::nullopt;
}

Vec3 Scene::mirrored_luminance(Vec3 normal, Vec3 direction) const {
  return surroundings_luminance(turned_to_viewer(mirrored(direction, normal)));
}

Vec3 Scene::car_luminance(Vec3 place, Vec3 world_direction) const {
  const Vec3 p = in_car(place), direction = turned_to_car(world_direction);
  const Vec3 normal = car_normal(p), world_normal = turned_to_viewer(normal);
  const double open = openness(p, normal), mirrors = fresnel(-dot(direction, normal));
  const Vec3 coat = (mirrors * open) * mirrored_luminance(normal, direction);
  switch (car_part(p, normal)) {
    case Part::paint:
      if (in_gap(p, normal)) return 0.25 * diffuse(kPaint, world_normal);
      return coat + open * diffuse(kPaint, world_normal) +
             (0.5 * open) * (kPaint * mirrored_luminance(normal, direction));
    case Part::windscreen:
    case Part::side_window:
      return 1.6 * coat +
             0.6 * cabin_luminance(p, direction, surroundings_luminance(world_direction));
    case Part::lamp: {
      const LampInside inside = inside_lamp(p, normal);
      return coat + inside.reflectance * mirrored_luminance(inside.normal, direction);
    }
    case Part::chrome:
      return (0.6 * open) * mirrored_luminance(normal, direction);
    case Part::plate:
      return open * diffuse(std::abs(p.x) > 0.252 || std::abs(p.y - 0.475) > 0.048
                                ? Vec3{0.05, 0.05, 0.05}
                                : Vec3{0.75, 0.74, 0.66},
                            world_normal);
    case Part::rim:
      return open * (on_spoke(p) ? Vec3{0.35, 0.35, 0.36} : Vec3{0.03, 0.03, 0.03}) *
             mirrored_luminance(normal, direction);
    case Part::tyre:
      return open * diffuse({0.03, 0.03, 0.03}, world_normal);
    case Part::grille:
    case Part::plastic:
      return 0.4 * coat + open * diffuse({0.022, 0.022, 0.024}, world_normal);
  }
  return {};
}

Vec3 Scene::street_luminance(Vec3 origin, Vec3 direction) const {
  const Vec3 seen = headlamp::street_luminance(origin, direction);
  if (direction.y >= 0) return seen;
  const Vec3 p = in_car(origin + (-origin.y / direction.y) * direction);
  const bool near = p.x > kCarLow.x - 0.6 && p.x < kCarHigh.x + 0.6 && p.z > kCarLow.z - 0.6 &&
                    p.z < kCarHigh.z + 0.6;
  return near ? openness(p, {0, 1, 0}) * seen : seen;
}

}  // namespace headlamp
