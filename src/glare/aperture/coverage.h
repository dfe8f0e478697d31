// Drawing the built-in eye by area: a pixel is the share of its square that a shape covers. Nothing
// but this knows the pixel's size. Internal.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "glare/aperture/eyelashes.h"

namespace glare {

struct Columns {
  int first = 0, last = 0;  // last is one past the end
};

/// The square picture's grid around the pupil's centre.
struct Grid {
  int size;
  double pixel;

  double edge(int index) const { return (index - 0.5 * size) * pixel; }
  double centre(int index) const { return edge(index) + 0.5 * pixel; }
  /// The columns that the interval from `left` to `right` touches.
  Columns touching(double left, double right) const {
    const double first = std::floor(left / pixel + 0.5 * size);
    const double last = std::ceil(right / pixel + 0.5 * size);
    return {static_cast<int>(std::clamp<double>(first, 0, size)),
            static_cast<int>(std::clamp<double>(last, 0, size))};
  }
};

/// Draws the columns of row `y` that the pupil of radius `r` touches, and returns them; the others
/// stay as they are. The share of a square inside the circle is exact.
Columns draw_pupil_row(const Grid& grid, int y, double r, std::span<float> row);

/// Area of the disc of radius `r` around the origin inside the rectangle from the origin to the
/// corner (x, y), negative where just one of x and y is.
double disc_area_in_quadrant(double x, double y, double r);

/// A short straight piece of a lash: a capsule whose radius changes from end to end.
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

/// A lash as a chain of segments. At this number of them the chain stays within 0.2 um of a lash
/// 5 mm long bowed by 7 %: curvature times segment length squared, over 8.
class Hair {
 public:
  explicit Hair(const Eyelash& lash);

  /// Darkens row `y` of the picture inside `open`. `covered` is a row of zeros, and is left so.
  void draw_row(const Grid& grid, int y, Columns open, std::span<float> covered,
                std::span<float> row) const;

 private:
  static constexpr int segment_count = 48;

  /// Unites `segment` with what is covered, and returns the columns it may have touched.
  static Columns cover_row(const Segment& segment, const Grid& grid, int y, Columns open,
                           std::span<float> covered);

  std::vector<Segment> segments_;
  double top_ = 1e30, bottom_ = -1e30;
};

}  // namespace glare
