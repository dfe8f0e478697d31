// Where a picture's pixels lie in the viewer's field of view.
#pragma once

#include <array>
#include <optional>

#include "glare/color/matrix.h"

namespace glare {

/// The most pixels that a camera's picture may have either way.
inline constexpr int kMostCameraPixels = 65536;

/// A perspective (rectilinear) picture of square pixels, whose axis is its middle. Directions and
/// places are (right, up, forward) of the viewer, places in metres. Columns and rows count from the
/// upper left; a whole number is a pixel's centre, so the axis is at ((width - 1) / 2, (height - 1)
/// / 2).
struct Camera {
  int width = 0, height = 0;      ///< Pixels, each 1 to kMostCameraPixels.
  double horizontal_fov_deg = 0;  ///< From the left border to the right one; 0.001 to 179.

  /// Pixels per unit of tangent: (width / 2) / tan(fov / 2).
  double focal_length_px() const;
  /// The unit vector towards a place in the picture, or beyond its borders.
  Vector3 direction_of(double column, double row) const;
  /// The place in the picture of a direction of any length but 0, which may be beyond the borders;
  /// nothing for one that isn't in front of the viewer.
  std::optional<std::array<double, 2>> pixel_of(const Vector3& direction) const;
};

/// Throws `OptionError` for a size or a field of view outside its range.
void require_valid(const Camera& camera);

}  // namespace glare
