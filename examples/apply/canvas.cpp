#include "canvas.h"

#include <atomic>
#include <cstdint>
#include <numbers>
#include <thread>

namespace scenes {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

void add_to(glare::Picture& picture, int x, int y, Vec3 light) {
  picture.channels[0](x, y) += static_cast<float>(light.x);
  picture.channels[1](x, y) += static_cast<float>(light.y);
  picture.channels[2](x, y) += static_cast<float>(light.z);
}

/// The share of a pixel within a disc, by 16 x 16 samples.
double share_within(double column, double row, double radius, int x, int y) {
  constexpr int kSamples = 16;
  int inside = 0;
  for (int i = 0; i < kSamples * kSamples; ++i)
    inside += std::hypot(x + (i % kSamples + 0.5) / kSamples - column,
                         y + (i / kSamples + 0.5) / kSamples - row) < radius;
  return static_cast<double>(inside) / (kSamples * kSamples);
}

/// A disc of less than a pixel is drawn as one of a pixel's width, with all its light.
void add_lamp(const Camera& camera, const Scene::Lamp& lamp, glare::Picture& picture) {
  const Vec3 to = lamp.place - camera.place;
  const double cosine = std::cos(camera.tilt_deg * kRadians);
  const double sine = std::sin(camera.tilt_deg * kRadians);
  const double scale = camera.focal_length_px() / (to.z * cosine + to.y * sine);
  const double column = 0.5 * camera.width + scale * to.x;
  const double row = 0.5 * camera.height - scale * (to.y * cosine - to.z * sine);
  const double true_radius = scale * lamp.radius_m, radius = std::max(0.5, true_radius);
  const double dimmed = true_radius * true_radius / (radius * radius);
  for (int y = std::max(0, static_cast<int>(row - radius));
       y <= std::min(camera.height - 1, static_cast<int>(row + radius)); ++y)
    for (int x = std::max(0, static_cast<int>(column - radius));
         x <= std::min(camera.width - 1, static_cast<int>(column + radius)); ++x)
      add_to(picture, x, y, (dimmed * share_within(column, row, radius, x, y)) * lamp.luminance);
}

void draw_row(const Scene& scene, int samples, int y, glare::Picture& picture) {
  const double weight = 1.0 / (samples * samples);
  for (int x = 0; x < scene.camera.width; ++x)
    for (int i = 0; i < samples * samples; ++i)
      add_to(picture, x, y,
             weight * scene.luminance(scene.camera.direction(x + (i % samples + 0.5) / samples,
                                                             y + (i / samples + 0.5) / samples)));
}

}  // namespace

double Camera::focal_length_px() const { return 0.5 * width / std::tan(0.5 * fov_deg * kRadians); }

Vec3 Camera::direction(double column, double row) const {
  const double right = (column - 0.5 * width) / focal_length_px();
  const double up = (0.5 * height - row) / focal_length_px();
  const double cosine = std::cos(tilt_deg * kRadians), sine = std::sin(tilt_deg * kRadians);
  return vectors::normalized({right, up * cosine + sine, cosine - up * sine});
}

glare::Picture drawn(const Scene& scene, int samples) {
  glare::Picture picture;
  for (auto& channel : picture.channels)
    channel = glare::Image<float>(scene.camera.width, scene.camera.height);
  std::atomic<int> next_row = 0;
  const auto work = [&] {
    for (int y = next_row++; y < scene.camera.height; y = next_row++)
      draw_row(scene, samples, y, picture);
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) others.emplace_back(work);
  work();
  others.clear();
  for (const Scene::Lamp& lamp : scene.lamps) add_lamp(scene.camera, lamp, picture);
  return picture;
}

double hashed(int a, int b) {
  auto h =
      static_cast<std::uint32_t>(a) * 0x9E3779B1u ^ static_cast<std::uint32_t>(b) * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return static_cast<double>(h ^ (h >> 15)) / 4294967296.0;
}

double noise(double x, double y) {
  constexpr double kFar = 1e6;  // Beyond, all is alike.
  const double column = std::clamp(std::floor(x), -kFar, kFar);
  const double row = std::clamp(std::floor(y), -kFar, kFar);
  const int i = static_cast<int>(column), j = static_cast<int>(row);
  const double u = vectors::smooth_step(0, 1, x - column), v = vectors::smooth_step(0, 1, y - row);
  return std::lerp(std::lerp(hashed(i, j), hashed(i + 1, j), u),
                   std::lerp(hashed(i, j + 1), hashed(i + 1, j + 1), u), v);
}

double fractal_noise(double x, double y) {
  return 0.5 * noise(x, y) + 0.3 * noise(2.1 * x + 7, 2.1 * y) + 0.2 * noise(4.3 * x, 4.3 * y + 3);
}

}  // namespace scenes
