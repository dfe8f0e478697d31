// The sun, low over a sea that glitters, and a boat.
#include <numbers>

#include "canvas.h"

namespace scenes {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kSunElevation_deg = 4.2, kSunAzimuth_deg = -3, kSunRadius_deg = 0.267;
/// Some 1.6e9 cd/m^2 above the air; so low, a tenth is left, and less of its blue.
constexpr Vec3 kSun{2.0e8, 1.45e8, 0.75e8};

Vec3 sun_direction() {
  const double elevation = kSunElevation_deg * kRadians, azimuth = kSunAzimuth_deg * kRadians;
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          std::cos(elevation) * std::cos(azimuth)};
}

/// Without the sun itself.
Vec3 sky(Vec3 direction) {
  const double elevation = std::asin(std::clamp(direction.y, 0.0, 1.0)) / kRadians;
  const double from_sun =
      std::acos(std::clamp(dot(direction, sun_direction()), -1.0, 1.0)) / kRadians;
  const double clouds =
      vectors::smooth_step(0.50, 0.72, fractal_noise(14 * direction.x + 3, 220 * direction.y + 1));
  const Vec3 clear = vectors::mix({950, 2100, 5200}, {5200, 4700, 4300}, std::exp(-elevation / 5));
  const Vec3 glow = std::exp(-from_sun / 7) * Vec3{7000, 4600, 2200};
  const double thin = 0.45 * clouds * vectors::smooth_step(1.5, 4, elevation);
  return vectors::mix(clear, {6800, 6200, 6000}, thin) + glow;
}

Vec3 sky_with_sun(Vec3 direction) {
  const bool on_sun = dot(direction, sun_direction()) > std::cos(kSunRadius_deg * kRadians);
  return on_sun ? kSun : sky(direction);
}

/// A wavy sea's height in metres.
double height(double x, double z) {
  return 0.55 * fractal_noise(0.10 * x + 0.03 * z, 0.22 * z) +
         0.10 * fractal_noise(0.9 * x + 40, 1.3 * z) + 0.022 * fractal_noise(5.1 * x, 6.3 * z + 9) +
         0.006 * noise(23 * x, 23 * z);
}

Vec3 wave_normal(double x, double z) {
  constexpr double kStep = 0.02;
  const double here = height(x, z);
  return vectors::normalized(
      {(here - height(x + kStep, z)) / kStep, 1, (here - height(x, z + kStep)) / kStep});
}

Vec3 sea(Vec3 eye, Vec3 direction) {
  const double reach = std::min(-eye.y / direction.y, 4e4);
  const Vec3 place = eye + reach * direction;
  const Vec3 normal = wave_normal(place.x, place.z);
  Vec3 mirrored_to = mirrored(direction, normal);
  mirrored_to.y = std::abs(mirrored_to.y);  // what a wave hides, another shows
  const double cosine = std::clamp(-dot(direction, normal), 0.0, 1.0);
  const double fresnel = 0.02 + 0.98 * std::pow(1 - cosine, 5);  // Schlick's, of water
  const Vec3 depth{40, 130, 190};
  const Vec3 seen = vectors::mix(depth, sky_with_sun(mirrored_to), std::min(fresnel, 0.6));
  return vectors::mix(seen, sky({direction.x, 0, direction.z}), 1 - std::exp(-reach / 9000));
}

/// A sailing boat against the light, by its place in front of the viewer; how wide it is at each
/// height.
bool on_boat(Vec3 eye, Vec3 direction) {
  constexpr double kAhead_m = 210, kRight_m = 27;
  const Vec3 p = eye + (kAhead_m / direction.z) * direction;
  const double x = p.x - kRight_m, y = p.y;
  const bool hull = y > -0.1 && y < 1.2 && x > -4.5 + 0.4 * (1.2 - y) && x < 5.2 - 1.1 * (1.2 - y);
  const bool mast = std::abs(x) < 0.09 && y > 0 && y < 14;
  const bool sail = y > 2 && y < 13.6 && x < -0.2 && x > -4.3 * std::sqrt((13.6 - y) / 11.6);
  const bool jib = y > 1.6 && y < 12 && x > 0.25 && x < 4.8 * (12 - y) / 10.4;
  return hull || mast || sail || jib;
}

Vec3 luminance(Vec3 eye, Vec3 direction) {
  if (on_boat(eye, direction)) return {190, 170, 165};
  return direction.y < 0 ? sea(eye, direction) : sky_with_sun(direction);
}

}  // namespace

Scene sun_glint() {
  Scene scene;
  scene.camera.place = {0, 5, 0};
  scene.camera.fov_deg = 32;
  scene.camera.tilt_deg = -2;
  scene.luminance = [eye = scene.camera.place](Vec3 direction) {
    return luminance(eye, direction);
  };
  return scene;
}

}  // namespace scenes
