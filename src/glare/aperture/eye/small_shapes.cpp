#include "glare/aperture/eye/small_shapes.h"

namespace glare {

namespace {

/// Integral of sqrt(r^2 - x^2) from 0 to `x`.
double circle_integral(double x, double r) {
  return 0.5 * (x * std::sqrt(std::max(r * r - x * x, 0.0)) + r * r * std::asin(x / r));
}

/// Share of a unit square inside a half-plane whose edge passes at the signed distance `depth` from
/// the square's centre, > 0 where the centre is inside. `normal` is the edge's unit normal.
double half_plane_share(double depth, Point normal) {
  const double a = std::max(std::abs(normal.x), std::abs(normal.y));
  const double b = std::min(std::abs(normal.x), std::abs(normal.y));
  const double corner = 0.5 * (a + b) - std::abs(depth);  // of the corner beyond the edge
  if (corner <= 0) return depth > 0 ? 1 : 0;
  if (corner >= b) return 0.5 + depth / a;
  const double cut = corner * corner / (2 * a * b);
  return depth > 0 ? 1 - cut : cut;
}

}  // namespace

double disc_area_in_quadrant(double x, double y, double r) {
  const double sign = (x < 0) == (y < 0) ? 1 : -1;
  x = std::min(std::abs(x), r);
  y = std::min(std::abs(y), r);
  if (x * x + y * y <= r * r) return sign * x * y;
  const double flat = std::sqrt(r * r - y * y);
  return sign * (flat * y + circle_integral(x, r) - circle_integral(flat, r));
}

float Segment::coverage(Point centre, double pixel) const {
  const Point offset = centre - from_;
  const double u = std::clamp(dot(offset, along_) / squared_length_, 0.0, 1.0);
  const Point away = offset - u * along_;
  const double radius = radius_ + u * widening_;
  const double squared = dot(away, away);
  const double reach = half_diagonal * pixel;
  if (squared >= (radius + reach) * (radius + reach)) return 0;
  if (radius > reach && squared <= (radius - reach) * (radius - reach)) return 1;
  const double distance = std::sqrt(squared);
  const bool beyond_end = (u == 0 || u == 1) && distance > 1e-9;
  const Point normal = beyond_end ? 1 / distance * away : normal_;
  // Inside the near edge, less what lies beyond the far edge.
  return static_cast<float>(half_plane_share((radius - distance) / pixel, normal) -
                            half_plane_share(-(radius + distance) / pixel, normal));
}

}  // namespace glare
