#include "glare/scene/disability_glare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "glare/base/range_check.h"
#include "glare/base/units.h"
#include "glare/scene/vector3.h"

namespace glare {

namespace {

/// Luminance at a place within the centres of the template's pixels, linear between them.
double luminance_at(const GlareTemplate& t, double column, double row) {
  const int x = std::clamp(static_cast<int>(column), 0, std::max(0, t.width() - 2));
  const int y = std::clamp(static_cast<int>(row), 0, std::max(0, t.height() - 2));
  const int right = std::min(x + 1, t.width() - 1), below = std::min(y + 1, t.height() - 1);
  const double u = column - x, v = row - y;
  return (1 - v) * ((1 - u) * t.luminance(x, y) + u * t.luminance(right, y)) +
         v * ((1 - u) * t.luminance(x, below) + u * t.luminance(right, below));
}

}  // namespace

double angle_between_deg(const Vector3& a, const Vector3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) / kRadPerDeg;
}

std::optional<double> template_veil_per_lux(const GlareTemplate& t, double angle_deg) {
  if (!(angle_deg >= 0) || !(angle_deg <= 90)) return std::nullopt;
  const auto [x, y] = t.center_px();
  const double radius_px = std::sin(angle_deg * kRadPerDeg) / t.pixel_pitch_rad;
  if (!(radius_px <= std::min({x, y, t.width() - 1 - x, t.height() - 1 - y}))) return std::nullopt;
  // Two places to a pixel; no fewer than make a small circle round.
  const int places = std::max(64, static_cast<int>(4 * std::numbers::pi * radius_px));
  double sum = 0;
  for (int i = 0; i < places; ++i) {
    const double turn = 2 * std::numbers::pi * i / places;
    sum += luminance_at(t, x + radius_px * std::cos(turn), y + radius_px * std::sin(turn));
  }
  return sum / places * t.per_steradian;
}

GlareSource glare_source(const LightAtEye& light, const Vector3& gaze) {
  return {light.illuminance_lux, angle_between_deg(light.direction, gaze)};
}

std::optional<double> cie_veiling_luminance(std::span<const GlareSource> sources,
                                            const Straylight& eye) {
  require_valid(eye);
  double sum = 0;
  for (const GlareSource& source : sources) {
    if (source.illuminance_lux == 0) continue;
    if (!(source.angle_deg >= kSmallestCieAngle_deg && source.angle_deg <= kLargestCieAngle_deg))
      return std::nullopt;
    sum += source.illuminance_lux * cie_general_glare(source.angle_deg, eye.age_years, eye.pigment);
  }
  return sum;
}

std::optional<double> threshold_increment_percent(double veiling_luminance,
                                                  double average_luminance) {
  constexpr double kMost = std::numeric_limits<double>::max();
  require_in_range("the veiling luminance in cd/m^2", veiling_luminance, 0, kMost);
  require_in_range("the average luminance in cd/m^2", average_luminance, 0, kMost);
  if (average_luminance <= 0.05) return std::nullopt;
  if (average_luminance <= 5) return 65 * veiling_luminance / std::pow(average_luminance, 0.8);
  return 95 * veiling_luminance / std::pow(average_luminance, 1.05);
}

double average_luminance(const Picture& picture, const Camera& camera) {
  require_valid(camera);
  for (const Image<float>& channel : picture.channels)
    if (channel.width() != camera.width || channel.height() != camera.height)
      throw OptionError("the picture's size isn't the camera's");
  const Vector3& weights = picture.color_space.xyz_from_rgb()[1];
  const double f = camera.focal_length_px();
  double sum = 0, solid_angle = 0;
  for (int y = 0; y < camera.height; ++y) {
    const double down = (y - 0.5 * (camera.height - 1)) / f;
    for (int x = 0; x < camera.width; ++x) {
      const double right = (x - 0.5 * (camera.width - 1)) / f;
      const double square = 1 + right * right + down * down;
      const double share = 1 / (square * std::sqrt(square));  // Of the cube of the cosine.
      solid_angle += share;
      for (std::size_t k = 0; k < 3; ++k) sum += share * weights[k] * picture.channels[k](x, y);
    }
  }
  return sum / solid_angle;
}

}  // namespace glare
