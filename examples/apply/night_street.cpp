// A wet street at night: street lamps, lit windows, a car ahead with its rear lamps on.
#include <numbers>

#include "canvas.h"

namespace scenes {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHouses_m = 8.5, kKerb_m = 5.2, kLampHeight_m = 6.2, kLampRight_m = 4.6;
constexpr Vec3 kSodium{1.75, 0.83, 0.06};  // at luminance 1, or near it
constexpr Vec3 kCar{1.9, 0, 15};           // the middle of its rear, on the road

std::vector<Scene::Lamp> street_lamps() {
  std::vector<Scene::Lamp> lamps;
  for (int i = 0; i < 7; ++i)
    for (const double side : {-1.0, 1.0})
      lamps.push_back({{side * kLampRight_m, kLampHeight_m, 17 + 19.0 * i + 6 * side},
                       0.11,
                       45000 * (side > 0 && i % 3 == 1 ? Vec3{0.92, 1.0, 1.15} : kSodium)});
  return lamps;
}

std::vector<Scene::Lamp> vehicle_lamps() {
  std::vector<Scene::Lamp> lamps;
  for (const double side : {-1.0, 1.0}) {
    lamps.push_back({kCar + Vec3{0.62 * side, 0.82, 0}, 0.05, {26000, 500, 60}});
    lamps.push_back({{-1.75 + 0.6 * side, 0.7, 62}, 0.06, {260000, 240000, 205000}});
  }
  return lamps;
}

double intensity_area(const Scene::Lamp& lamp) { return kPi * lamp.radius_m * lamp.radius_m; }

/// Lux, from lamps that shine down.
Vec3 illuminance(const std::vector<Scene::Lamp>& lamps, Vec3 place, Vec3 normal) {
  Vec3 sum;
  for (const Scene::Lamp& lamp : lamps) {
    const Vec3 to = lamp.place - place;
    const double squared = std::max(dot(to, to), 0.3),
                 cosine = dot(to, normal) / std::sqrt(squared);
    sum = sum + (intensity_area(lamp) * std::max(0.0, cosine) / squared) * lamp.luminance;
  }
  return sum;
}

Vec3 sky(Vec3 direction) {
  const double up = std::max(direction.y, 0.0);
  return vectors::mix({0.10, 0.075, 0.065}, {0.012, 0.015, 0.03}, vectors::smooth_step(0, 0.5, up));
}

/// On a row of houses: z along the street, y up.
double roof_m(double z) { return 8.5 + 6 * hashed(static_cast<int>(std::floor(z / 11)), 17); }

Vec3 facade(const std::vector<Scene::Lamp>& lamps, Vec3 place) {
  const int side = place.x > 0 ? 1 : 0;
  const int house = static_cast<int>(std::floor(place.z / 11));
  const double across = std::fmod(place.z, 2.75) / 2.75, up = std::fmod(place.y, 3.1) / 3.1;
  const int column = static_cast<int>(place.z / 2.75), storey = static_cast<int>(place.y / 3.1);
  const bool window = across > 0.28 && across < 0.72 && up > 0.30 && up < 0.80;
  const bool frame = std::abs(across - 0.5) < 0.015 || std::abs(up - 0.62) < 0.012;
  if (window && !frame) {
    const double pick = hashed(3 * column + side, storey + 31);
    if (pick > 0.36) return {0.02, 0.022, 0.03};
    const double curtain = 0.45 + 0.55 * noise(26 * across + 9 * pick, 0.5 * storey);
    return (35 + 190 * pick) * curtain *
           (pick < 0.08 ? Vec3{0.8, 0.95, 1.2} : Vec3{1.5, 0.9, 0.35});
  }
  const double tone = 0.16 + 0.16 * hashed(house, 5 + side);
  const Vec3 wall = tone * Vec3{1.0, 0.86, 0.75};
  const double grain = 0.8 + 0.4 * fractal_noise(3 * place.z, 5 * place.y);
  const Vec3 normal{side == 1 ? -1.0 : 1.0, 0, 0};
  return (grain / kPi) * (wall * (0.6 * illuminance(lamps, place, normal) + Vec3{0.3, 0.3, 0.4}));
}

/// The car's rear, as a silhouette with a window; nothing beside it.
bool on_car(Vec3 p) {
  const double x = std::abs(p.x - kCar.x), y = p.y;
  const bool body = y > 0.28 && y < 1.0 && x < 0.86 - 0.1 * std::abs(y - 0.7);
  const bool cabin = y >= 1.0 && y < 1.46 && x < 0.78 - 0.55 * (y - 1.0);
  const bool wheel = y > 0 && y <= 0.3 && x > 0.55 && x < 0.78;
  return body || cabin || wheel;
}

Vec3 car(Vec3 p) {
  const double x = std::abs(p.x - kCar.x);
  if (x < 0.26 && p.y > 0.55 && p.y < 0.66) return {1.6, 1.5, 1.2};
  if (p.y > 1.06 && p.y < 1.40 && x < 0.70 - 0.55 * (p.y - 1.0)) return {0.05, 0.05, 0.06};
  const double lamp = std::hypot((x - 0.62) / 0.16, (p.y - 0.82) / 0.08);
  const Vec3 paint = (p.y > 0.3 ? 1.0 : 0.2) * Vec3{0.16, 0.13, 0.12};
  return lamp < 1 ? Vec3{420, 9, 2} : paint + std::exp(-1.5 * lamp) * Vec3{6, 0.2, 0.05};
}

class Street {
 public:
  Street() : street_lamps_(street_lamps()), all_lamps_(street_lamps_) {
    for (const Scene::Lamp& lamp : vehicle_lamps()) all_lamps_.push_back(lamp);
  }

  Vec3 luminance(Vec3 eye, Vec3 direction) const {
    const double to_ground = direction.y < 0 ? -eye.y / direction.y : 1e9;
    const double to_car = (kCar.z - eye.z) / direction.z;
    if (to_car > 0 && to_car < to_ground && on_car(eye + to_car * direction))
      return car(eye + to_car * direction);
    if (const double pole = to_pole(eye, direction); pole > 0 && pole < to_ground)
      return {0.03, 0.026, 0.02};
    const double to_house =
        (std::copysign(kHouses_m, direction.x) - eye.x) / (direction.x == 0 ? 1e-9 : direction.x);
    if (to_ground < to_house) return ground(eye + to_ground * direction, direction);
    const Vec3 place = eye + to_house * direction;
    return place.y < roof_m(place.z + (direction.x > 0 ? 300 : 0)) && place.z < 400
               ? facade(street_lamps_, place)
               : sky(direction);
  }

  const std::vector<Scene::Lamp>& lamps() const { return all_lamps_; }

 private:
  /// Of a lamp: upright, 6 cm thick, at the kerb, with an arm to the lamp.
  double to_pole(Vec3 eye, Vec3 direction) const {
    for (const Scene::Lamp& lamp : street_lamps_) {
      const double reach = (lamp.place.z + 0.15 - eye.z) / direction.z;
      const Vec3 p = eye + reach * direction;
      const double out = std::abs(p.x) - kKerb_m - 0.25;
      if (p.x * lamp.place.x < 0 || reach < 0) continue;
      const bool upright = std::abs(out) < 0.06 && p.y < kLampHeight_m + 0.2;
      const bool arm = out < 0 && out > -1.1 && std::abs(p.y - kLampHeight_m - 0.16) < 0.05;
      if (upright || arm) return reach;
    }
    return -1;
  }

  Vec3 ground(Vec3 place, Vec3 direction) const {
    const bool pavement = std::abs(place.x) > kKerb_m;
    const double grain = 0.7 + 0.6 * fractal_noise(9 * place.x, 9 * place.z);
    const bool dash = std::abs(place.x) < 0.07 && std::fmod(place.z, 7) < 3;
    const double reflectance = pavement ? 0.13 : dash ? 0.35 : 0.05;
    const Vec3 light = illuminance(street_lamps_, place, {0, 1, 0});
    const double wet =
        vectors::smooth_step(0.35, 0.62, fractal_noise(0.5 * place.x, 0.25 * place.z));
    const Vec3 ripples = 0.012 * Vec3{noise(31 * place.x, 31 * place.z) - 0.5, 0,
                                      noise(31 * place.x + 9, 31 * place.z) - 0.5};
    const Vec3 normal = normalized(Vec3{0, 1, 0} + (1.6 - wet) * ripples);
    return (reflectance * grain / kPi) * light + mirrored_light(place, direction, normal, wet);
  }

  /// In the water: houses, car and sky as in a mirror, and lamps by a rough surface's facets.
  Vec3 mirrored_light(Vec3 place, Vec3 direction, Vec3 normal, double wet) const {
    Vec3 on = mirrored(direction, normal);
    on.y = std::max(on.y, 1e-4);
    const double cosine = std::clamp(-dot(direction, normal), 0.02, 1.0);
    const double fresnel = 0.02 + 0.98 * std::pow(1 - cosine, 5);
    const double slope = 0.09 - 0.055 * wet;  // root mean square
    Vec3 sum = (0.2 + 0.7 * wet) * fresnel * luminance(place + Vec3{0, 1e-3, 0}, on);
    for (const Scene::Lamp& lamp : all_lamps_) {
      const Vec3 to = lamp.place - place;
      const double squared = dot(to, to);
      const Vec3 half = normalized((1 / std::sqrt(squared)) * to - direction);
      const double upright = std::max(dot(half, normal), 0.05);
      const double tilt = (1 / (upright * upright) - 1) / (2 * slope * slope);
      if (tilt > 30) continue;
      const double facets =
          std::exp(-tilt) / (2 * kPi * slope * slope * std::pow(upright, 4));  // Beckmann's
      const double facing = std::pow(1 - std::max(0.0, -dot(direction, half)), 5);
      sum = sum + (intensity_area(lamp) / squared * facets * (0.02 + 0.98 * facing) /
                   (4 * std::max(cosine, 0.08)) * (0.25 + 0.75 * wet)) *
                      lamp.luminance;
    }
    return sum;
  }

  std::vector<Scene::Lamp> street_lamps_, all_lamps_;
};

}  // namespace

Scene night_street() {
  Scene scene;
  scene.camera.place = {0.5, 1.6, 0};
  scene.camera.fov_deg = 40;
  scene.camera.tilt_deg = 4;
  const Street street;
  scene.lamps = street.lamps();
  scene.luminance = [street, eye = scene.camera.place](Vec3 direction) {
    return street.luminance(eye, direction);
  };
  return scene;
}

}  // namespace scenes
