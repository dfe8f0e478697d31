#include "glare/aperture/coverage.h"

namespace glare {

namespace {

/// Integral of sqrt(r^2 - x^2) from 0 to `x`.
double circle_integral(double x, double r) {
  return 0.5 * (x * std::sqrt(std::max(r * r - x * x, 0.0)) + r * r * std::asin(x / r));
}

/// Area of the disc of radius `r` inside the rectangle from the centre to the corner (x, y),
/// negative where just one of x and y is.
double quadrant_area(double x, double y, double r) {
  const double sign = (x < 0) == (y < 0) ? 1 : -1;
  x = std::min(std::abs(x), r);
  y = std::min(std::abs(y), r);
  if (x * x + y * y <= r * r) return sign * x * y;
  const double flat = std::sqrt(r * r - y * y);
  return sign * (flat * y + circle_integral(x, r) - circle_integral(flat, r));
}

/// Area of the disc of radius `r` inside the square with top left corner (x, y).
double disc_area_in_square(double x, double y, double side, double r) {
  return quadrant_area(x + side, y + side, r) - quadrant_area(x, y + side, r) -
         quadrant_area(x + side, y, r) + quadrant_area(x, y, r);
}

double half_chord(double y, double r) { return std::sqrt(std::max(r * r - y * y, 0.0)); }

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

double disc_area_in_quadrant(double x, double y, double r) { return quadrant_area(x, y, r); }

Columns draw_pupil_row(const Grid& grid, int y, double r, std::span<float> row) {
  const double top = grid.edge(y), bottom = grid.edge(y + 1);
  const double nearest = top <= 0 && bottom >= 0 ? 0 : std::min(std::abs(top), std::abs(bottom));
  const double farthest = std::max(std::abs(top), std::abs(bottom));
  if (nearest >= r) return {};
  const double outer = half_chord(nearest, r), inner = half_chord(farthest, r);
  const Columns touched = grid.touching(-outer, outer);
  for (int x = touched.first; x < touched.last; ++x) {
    const double left = grid.edge(x);
    if (left >= -inner && left + grid.pixel <= inner) {
      row[x] = 1;
    } else {
      const double area = disc_area_in_square(left, top, grid.pixel, r);
      row[x] = static_cast<float>(std::clamp(area / (grid.pixel * grid.pixel), 0.0, 1.0));
    }
  }
  return touched;
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

Hair::Hair(const Eyelash& lash) {
  constexpr double tip_share = 0.2;
  const auto axis = [&](double t) {
    return (1 - t) * (1 - t) * lash.root + 2 * t * (1 - t) * lash.bend + t * t * lash.tip;
  };
  const auto radius = [&](double t) { return 0.5 * lash.root_width * (1 - (1 - tip_share) * t); };
  constexpr double step = 1.0 / segment_count;
  for (int i = 0; i < segment_count; ++i)
    segments_.emplace_back(axis(i * step), axis((i + 1) * step), radius(i * step),
                           radius((i + 1) * step));
  for (const Segment& segment : segments_) {
    top_ = std::min(top_, segment.top());
    bottom_ = std::max(bottom_, segment.bottom());
  }
}

void Hair::draw_row(const Grid& grid, int y, Columns open, std::span<float> covered,
                    std::span<float> row) const {
  if (bottom_ < grid.edge(y) || top_ > grid.edge(y + 1)) return;
  Columns touched{open.last, open.first};
  for (const Segment& segment : segments_) {
    const Columns part = cover_row(segment, grid, y, open, covered);
    touched.first = std::min(touched.first, part.first);
    touched.last = std::max(touched.last, part.last);
  }
  for (int x = touched.first; x < touched.last; ++x) {
    row[x] *= 1 - covered[x];
    covered[x] = 0;
  }
}

Columns Hair::cover_row(const Segment& segment, const Grid& grid, int y, Columns open,
                        std::span<float> covered) {
  const Columns none{open.last, open.first};
  if (segment.bottom() < grid.edge(y) || segment.top() > grid.edge(y + 1)) return none;
  Columns part = grid.touching(segment.left(), segment.right());
  part = {std::max(part.first, open.first), std::min(part.last, open.last)};
  if (part.first >= part.last) return none;
  for (int x = part.first; x < part.last; ++x)
    if (covered[x] < 1)
      covered[x] =
          std::max(covered[x], segment.coverage({grid.centre(x), grid.centre(y)}, grid.pixel));
  return part;
}

}  // namespace glare
