// Shapes of which a square's share follows from a formula. Internal.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glare/aperture/coverage.h"

namespace glare {

/// Area of the disc of radius `r` around the origin inside the rectangle from the origin to the
/// corner (x, y), negative where just one of x and y is.
double disc_area_in_quadrant(double x, double y, double r);

/// A straight strip with round ends, whose radius changes from end to end.
class Segment {
 public:
  Segment(Point from, Point to, double from_radius, double to_radius)
      : from_(from),
        along_(to - from),
        squared_length_(std::max(dot(along_, along_), 1e-30)),
        normal_(1 / std::sqrt(squared_length_) * Point{along_.y, -along_.x}),
        radius_(from_radius),
        widening_(to_radius - from_radius) {}

  double top() const { return std::min(from_.y, from_.y + along_.y) - max_radius(); }
  double bottom() const { return std::max(from_.y, from_.y + along_.y) + max_radius(); }
  double left() const { return std::min(from_.x, from_.x + along_.x) - max_radius(); }
  double right() const { return std::max(from_.x, from_.x + along_.x) + max_radius(); }

  /// Share of the square of side `pixel` around `centre` that the segment covers.
  float coverage(Point centre, double pixel) const;

 private:
  static constexpr double half_diagonal = 0.5 * std::numbers::sqrt2;
  double max_radius() const { return std::max(radius_, radius_ + widening_); }

  Point from_, along_;
  double squared_length_;
  Point normal_;
  double radius_, widening_;
};

}  // namespace glare
