// Lengths and products of vectors. Internal.
#pragma once

#include <cmath>

#include "glare/color/matrix.h"

namespace glare {

inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }
inline Vector3 scaled(const Vector3& v, double factor) {
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}
/// Of length 1; `v` isn't 0.
inline Vector3 unit(const Vector3& v) { return scaled(v, 1 / length(v)); }
inline bool is_finite(const Vector3& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

}  // namespace glare
