// Vectors, and shapes as signed distances: negative inside, in metres.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "../vectors.h"

namespace headlamp {

using vectors::dot, vectors::length, vectors::mirrored, vectors::mix, vectors::normalized;
using vectors::smooth_step, vectors::Vec3;

struct Vec2 {
  double x = 0, y = 0;
};

/// The distance to a polygon's outline, negative inside.
double polygon(std::span<const Vec2> corners, Vec2 p);

/// The distance to a box about the origin, whose edges are rounded within its half sizes.
inline double rounded_box(Vec3 p, Vec3 half, double radius) {
  const Vec3 q{std::abs(p.x) - half.x + radius, std::abs(p.y) - half.y + radius,
               std::abs(p.z) - half.z + radius};
  const Vec3 outside{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return length(outside) + std::min(std::max({q.x, q.y, q.z}), 0.0) - radius;
}

inline double rounded_rectangle(Vec2 p, Vec2 half, double radius) {
  return rounded_box({p.x, p.y, 0}, {half.x, half.y, 1e3}, radius);
}

/// A disc across x, of half a width, whose rim is rounded.
inline double disc(Vec3 p, double radius, double half_width, double rim) {
  return rounded_rectangle({std::hypot(p.y, p.z), p.x}, {radius, half_width}, rim);
}

/// What is in both, with an edge rounded over `radius`.
inline double rounded_intersection(double a, double b, double radius) {
  const double overlap = std::max(radius - std::abs(a - b), 0.0) / radius;
  return std::max(a, b) + 0.25 * radius * overlap * overlap;
}

/// What is in either, with a fillet of `radius`.
inline double filleted_union(double a, double b, double radius) {
  return -rounded_intersection(-a, -b, radius);
}

}  // namespace headlamp
