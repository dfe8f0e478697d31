// A Christmas tree with many small coloured lights in a dark room.
#include <numbers>

#include "canvas.h"

namespace scenes {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr Vec3 kFoot{0, 0, 3.6};
constexpr double kTop_m = 2.05, kLowest_m = 0.28, kWidest_m = 0.72, kWall_m = 4.9;
constexpr double kBulb_m = 0.0035;
constexpr int kLights = 170, kTurns = 8;

/// Of each colour a bulb's luminance, cd/m^2.
constexpr std::array<Vec3, 5> kColors{{{42000, 26000, 9000},
                                       {52000, 1500, 900},
                                       {2200, 34000, 3200},
                                       {2600, 7000, 76000},
                                       {48000, 15000, 600}}};

/// Tiers of branches: how far the tree reaches from its trunk at a height and an azimuth.
double reach_at(double y, double azimuth) {
  constexpr int kTiers = 8;
  const double share = (kTop_m - y) / (kTop_m - kLowest_m);  // 0 at the top
  if (share < 0 || share > 1) return 0;
  const double tier = std::fmod(kTiers * share, 1.0);
  const double branches = fractal_noise(7 * azimuth, 26 * share);
  return kWidest_m * share * (0.62 + 0.30 * tier + 0.34 * (branches - 0.5)) + 0.01;
}

std::vector<Scene::Lamp> lights() {
  std::vector<Scene::Lamp> lamps;
  for (int i = 0; i < kLights; ++i) {
    const double share = 0.05 + 0.93 * std::sqrt((i + 0.5) / kLights);
    const double azimuth = 2 * kPi * kTurns * share + 0.5 * (hashed(i, 3) - 0.5);
    const double y = kTop_m - share * (kTop_m - kLowest_m) + 0.03 * (hashed(i, 5) - 0.5);
    const double reach = reach_at(y, azimuth) + 0.02;
    const Vec3 place = kFoot + Vec3{reach * std::cos(azimuth), y, -reach * std::sin(azimuth)};
    lamps.push_back({place, kBulb_m, kColors[static_cast<std::size_t>(5 * hashed(i, 7))]});
  }
  lamps.push_back({kFoot + Vec3{0, kTop_m + 0.06, 0}, 0.012, {30000, 24000, 13000}});
  return lamps;
}

bool is_in_front(const Scene::Lamp& lamp) { return lamp.place.z < kFoot.z + 0.02; }

/// From all lights on a surface, lux: each has the intensity of its disc, everywhere.
Vec3 illuminance(const std::vector<Scene::Lamp>& lamps, Vec3 place, Vec3 normal) {
  Vec3 sum;
  for (const Scene::Lamp& lamp : lamps) {
    const Vec3 to = lamp.place - place;
    const double squared = std::max(dot(to, to), 4e-4);
    const double cosine = std::max(0.0, dot(to, normal) / std::sqrt(squared));
    sum = sum + (kPi * lamp.radius_m * lamp.radius_m * cosine / squared) * lamp.luminance;
  }
  return sum;
}

/// Where a ray enters the tree, by steps through the cylinder around it; below 0: it doesn't.
double reach_of_tree(Vec3 eye, Vec3 direction) {
  constexpr double kStep_m = 0.012;
  const Vec3 to = kFoot - eye;
  const double nearest = (to.x * direction.x + to.z * direction.z) /
                         (direction.x * direction.x + direction.z * direction.z);
  const Vec3 p = eye + nearest * direction;
  if (std::abs(p.x) > kWidest_m || p.y > kTop_m + 0.3 || p.y < 0) return -1;
  for (double at = nearest - kWidest_m; at < nearest + 0.1; at += kStep_m) {
    const Vec3 q = eye + at * direction - kFoot;
    if (std::hypot(q.x, q.z) < reach_at(q.y, std::atan2(-q.z, q.x))) return at;
  }
  return -1;
}

Vec3 needles(const std::vector<Scene::Lamp>& lamps, Vec3 place) {
  const Vec3 out{place.x - kFoot.x, 0.35, place.z - kFoot.z};
  const double grain = fractal_noise(130 * place.x + 40 * place.y, 150 * place.y + 60 * place.z);
  const Vec3 light = illuminance(lamps, place - 0.02 * out, normalized(out));
  return (1.8 * grain * grain / kPi) * (Vec3{0.05, 0.11, 0.045} * (light + Vec3{2, 2, 2.4}));
}

Vec3 room(const std::vector<Scene::Lamp>& lamps, Vec3 eye, Vec3 direction) {
  const double to_wall = (kWall_m - eye.z) / direction.z;
  const double to_floor = direction.y < 0 ? -eye.y / direction.y : 1e9;
  const bool is_floor = to_floor < to_wall;
  const Vec3 place = eye + std::min(to_floor, to_wall) * direction;
  const Vec3 light = illuminance(lamps, place, is_floor ? Vec3{0, 1, 0} : Vec3{0, 0, -1});
  const double board = fractal_noise(2.5 * place.x, 60 * place.z);
  const bool skirting = place.y < 0.12;
  const Vec3 reflectance = is_floor   ? (0.6 + 0.6 * board) * Vec3{0.20, 0.11, 0.06}
                           : skirting ? Vec3{0.5, 0.48, 0.44}
                                      : Vec3{0.34, 0.25, 0.19};
  // The tree is in the way of half its lights, and its foot in the way of more.
  const double shadow = is_floor ? vectors::smooth_step(0.1, 0.9, length(place - kFoot)) : 1.0;
  return (0.5 * shadow / kPi) * (reflectance * (light + Vec3{0.8, 0.8, 1.1}));
}

bool on_trunk(Vec3 eye, Vec3 direction) {
  const Vec3 p = eye + ((kFoot.z - eye.z) / direction.z) * direction;
  return p.y > 0 && p.y < 0.4 && std::abs(p.x) < (p.y < 0.14 ? 0.16 : 0.05);
}

}  // namespace

Scene christmas_tree() {
  Scene scene;
  scene.camera.place = {0, 1.05, -0.6};
  scene.camera.fov_deg = 52;
  scene.luminance = [lamps = lights(), eye = scene.camera.place](Vec3 direction) {
    const double at = reach_of_tree(eye, direction);
    if (at > 0) return needles(lamps, eye + at * direction);
    return on_trunk(eye, direction) ? Vec3{0.12, 0.06, 0.03} : room(lamps, eye, direction);
  };
  for (const Scene::Lamp& lamp : lights())
    if (is_in_front(lamp)) scene.lamps.push_back(lamp);
  return scene;
}

}  // namespace scenes
