#include "glare/aperture/eye/small_shapes.h"

namespace glare {

namespace {

/// The arcsine for x from 0 to 1, to 2e-8 (Abramowitz and Stegun 1964, 4.4.46).
double arcsine(double x) {
  constexpr double terms[] = {-0.0012624911, 0.0066700901, -0.0170881256, 0.0308918810,
                              -0.0501743046, 0.0889789874, -0.2145988016, 1.5707963050};
  double sum = 0;
  for (const double term : terms) sum = sum * x + term;
  return std::numbers::pi / 2 - std::sqrt(1 - x) * sum;
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

double DiscRow::quarter_disc_to(double x) const {
  const double squared = radius_ * radius_;
  return 0.5 * (x * std::sqrt(std::max(squared - x * x, 0.0)) +
                squared * arcsine(std::min(x / radius_, 1.0)));
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
