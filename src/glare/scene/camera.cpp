#include "glare/scene/camera.h"

#include <cmath>

#include "glare/base/range_check.h"
#include "glare/base/units.h"

namespace glare {

double Camera::focal_length_px() const {
  return 0.5 * width / std::tan(0.5 * horizontal_fov_deg * kRadPerDeg);
}

Vector3 Camera::direction_of(double column, double row) const {
  const double x = column - 0.5 * (width - 1), y = 0.5 * (height - 1) - row;
  const double z = focal_length_px(), length = std::hypot(x, y, z);
  return {x / length, y / length, z / length};
}

std::optional<std::array<double, 2>> Camera::pixel_of(const Vector3& direction) const {
  const auto [right, up, forward] = direction;
  if (!(forward > 0)) return std::nullopt;
  const double f = focal_length_px();
  return std::array{0.5 * (width - 1) + f * right / forward, 0.5 * (height - 1) - f * up / forward};
}

void require_valid(const Camera& camera) {
  require_in_range("the picture's width in pixels", camera.width, 1, kMostCameraPixels);
  require_in_range("the picture's height in pixels", camera.height, 1, kMostCameraPixels);
  require_in_range("the picture's horizontal field of view in degrees", camera.horizontal_fov_deg,
                   0.001, 179);
}

}  // namespace glare
