// Shapes of which a square's share follows from a formula. Internal.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glare/aperture/coverage.h"

namespace glare {

/// What a row of height `bottom - top` holds of the disc of radius `r` around the origin. Areas are
/// exact to 2e-8 r^2.
class DiscRow {
 public:
  DiscRow(double r, double top, double bottom)
      : radius_(r), top_(edge(top)), bottom_(edge(bottom)) {}

  /// Area between the vertical through the origin and the one at `x`, negative where x is.
  double area_to(double x) const {
    const double along = std::min(std::abs(x), radius_);
    const bool inside = along <= top_.flat && along <= bottom_.flat;
    const double circle = inside ? 0 : quarter_disc_to(along);
    return std::copysign(bottom_.area_to(along, circle) - top_.area_to(along, circle), x);
  }

 private:
  /// One of the row's edges.
  struct Edge {
    double y;     // Within the disc.
    double flat;  // Half the chord that the edge cuts off.
    double sign, rest;
    /// Area between the edge, y = 0 and the vertical at 0 and `x` > 0, negative where y is. Beyond
    /// the chord it ends at the circle.
    double area_to(double x, double circle) const {
      return x <= flat ? x * y : rest + sign * circle;
    }
  };
  Edge edge(double y) const {
    y = std::clamp(y, -radius_, radius_);
    const double flat = std::sqrt(radius_ * radius_ - y * y), sign = y < 0 ? -1 : 1;
    return {y, flat, sign, y * flat - sign * quarter_disc_to(flat)};
  }
  /// Integral of sqrt(r^2 - x^2) from 0 to `x`, which is from 0 to r.
  double quarter_disc_to(double x) const;

  double radius_;
  Edge top_, bottom_;
};

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
