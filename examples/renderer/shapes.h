// Shapes that rays meet: spheres and planes, in metres.
#pragma once

#include <optional>

#include "../vectors.h"

namespace renderer {

using vectors::Vec3;

struct Ray {
  Vec3 origin, direction;  ///< The direction has length 1.
  Vec3 at(double distance) const { return origin + distance * direction; }
};

/// A ray that meets a shape nearer than this has only just left it.
inline constexpr double kNearest_m = 1e-5;

struct Sphere {
  Vec3 center;
  double radius = 1;

  /// The distance at which a ray meets it, from outside or from inside.
  std::optional<double> met_by(const Ray& ray) const {
    const Vec3 to_center = center - ray.origin;
    const double middle = dot(to_center, ray.direction);
    const Vec3 miss = to_center - middle * ray.direction;
    const double inside = radius * radius - dot(miss, miss);
    if (inside < 0) return std::nullopt;
    const double half_chord = std::sqrt(inside);
    if (middle - half_chord > kNearest_m) return middle - half_chord;
    if (middle + half_chord > kNearest_m) return middle + half_chord;
    return std::nullopt;
  }
  Vec3 normal_at(Vec3 place) const { return (1 / radius) * (place - center); }
};

struct Plane {
  Vec3 normal;          ///< Of length 1.
  double offset_m = 0;  ///< From the origin, along the normal.

  std::optional<double> met_by(const Ray& ray) const {
    const double distance =
        (offset_m - dot(normal, ray.origin)) / dot(normal, ray.direction);  // may be infinite
    if (distance > kNearest_m && distance < 1e6) return distance;
    return std::nullopt;
  }
};

}  // namespace renderer
