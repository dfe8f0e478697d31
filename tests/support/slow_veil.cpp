#include "support/slow_veil.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glare::test {

namespace {

/// A vector turned about an axis of length 1 (Rodrigues).
Vector3 turned(const Vector3& v, const Vector3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
  const Vector3 cross = {axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2],
                         axis[0] * v[1] - axis[1] * v[0]};
  Vector3 out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = v[k] * c + cross[k] * s + axis[k] * along * (1 - c);
  return out;
}

double value_at(const GlareTemplate& t, double column, double row, double softness) {
  const auto pixel = [&](int x, int y) -> double {
    return x < 0 || y < 0 || x >= t.width() || y >= t.height() ? 0 : t.channels[0](x, y);
  };
  if (softness == 0)
    return pixel(static_cast<int>(std::floor(column + 0.5)),
                 static_cast<int>(std::floor(row + 0.5)));
  const int x = static_cast<int>(std::floor(column)), y = static_cast<int>(std::floor(row));
  const auto blend = [&](double share) {
    return std::clamp((share - 0.5) / softness + 0.5, 0.0, 1.0);
  };
  const double u = blend(column - x), v = blend(row - y);
  return (1 - v) * ((1 - u) * pixel(x, y) + u * pixel(x + 1, y)) +
         v * ((1 - u) * pixel(x, y + 1) + u * pixel(x + 1, y + 1));
}

}  // namespace

std::array<double, 2> sines_about(const Camera& camera, const Vector3& lamp, double column,
                                  double row) {
  const double focal_px =
      0.5 * camera.width / std::tan(0.5 * camera.horizontal_fov_deg * std::numbers::pi / 180);
  Vector3 v = {(column - 0.5 * (camera.width - 1)) / focal_px,
               (0.5 * (camera.height - 1) - row) / focal_px, 1};
  const double length = std::hypot(v[0], v[1], v[2]);
  for (double& x : v) x /= length;
  // Turned back from the lamp to the axis: about lamp x axis.
  const double away = std::hypot(lamp[0], lamp[1]);
  if (away > 0) v = turned(v, {-lamp[1] / away, lamp[0] / away, 0}, -std::atan2(away, lamp[2]));
  return {v[0], -v[1]};
}

double slow_veil(const GlareTemplate& t, const Camera& camera, const Vector3& lamp, int column,
                 int row, const SlowVeil& how) {
  const auto center = t.center_px();
  double sum = 0;
  for (int j = 0; j < how.places; ++j)
    for (int i = 0; i < how.places; ++i) {
      const auto s = sines_about(camera, lamp, column - 0.5 + (i + 0.5) / how.places,
                                 row - 0.5 + (j + 0.5) / how.places);
      sum += value_at(t, s[0] / t.pixel_pitch_rad + center[0], s[1] / t.pixel_pitch_rad + center[1],
                      how.softness);
    }
  return sum / (how.places * how.places);
}

double sine_area(const Camera& camera, const Vector3& lamp, int column, int row) {
  const auto a = sines_about(camera, lamp, column - 0.5, row - 0.5);
  const auto b = sines_about(camera, lamp, column + 0.5, row - 0.5);
  const auto c = sines_about(camera, lamp, column + 0.5, row + 0.5);
  const auto d = sines_about(camera, lamp, column - 0.5, row + 0.5);
  return 0.5 * std::abs((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]));
}

}  // namespace glare::test
