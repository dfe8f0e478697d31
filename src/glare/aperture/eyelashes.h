// Where the built-in eye's lashes are: curves in the pupil's plane. Internal.
#pragma once

#include <vector>

#include "glare/aperture/eye.h"

namespace glare {

/// Millimetres from the pupil's centre, x to the right and y down.
struct Point {
  double x = 0, y = 0;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }

/// A lash's axis is the quadratic Bezier curve root, bend, tip.
struct Eyelash {
  Point root, bend, tip;
  double root_width;
};

/// The lashes in front of the pupil; the same for the same parameters on every machine.
std::vector<Eyelash> eyelashes(const EyeParameters& parameters);

}  // namespace glare
