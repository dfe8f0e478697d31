// Drawing by area: a pixel is the share of its square that a shape covers. Nothing but this knows
// the pixel's size. Internal.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace glare {

/// Millimetres from the eye's axis, x to the right and y down.
struct Point {
  double x = 0, y = 0;
};
inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }

struct Columns {
  int first = 0, last = 0;  // last is one past the end
};

/// The square picture's grid around the eye's axis.
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

/// What shares of a row's squares lie inside of a shape, from the shape's edges: the running sum of
/// what each edge covers to its right.
class RowCoverage {
 public:
  explicit RowCoverage(int columns)
      : columns_(columns), height_(columns + 1, 0.0), area_(columns + 1, 0.0) {}

  /// Adds an edge from (x0, y0) to (x1, y1), in pixels from the row's top left corner, with y from
  /// 0 to 1. What is right of it gains y0 - y1.
  void add_edge(double x0, double y0, double x1, double y1);

  /// Calls `paint(first, last, share)` for runs of columns that are covered, from left to right,
  /// and forgets the edges.
  template <typename Paint>
  void paint(Paint&& paint) {
    merge_touched();
    double covered = 0;
    int next = 0;  // where columns without an edge began
    for (const Columns& part : touched_) {
      paint_run(next, part.first, covered, paint);
      for (int x = part.first; x < part.last; ++x) {
        paint_run(x, x + 1, covered + area_[x], paint);
        covered += height_[x];
        height_[x] = area_[x] = 0;
      }
      next = part.last;
    }
    paint_run(next, columns_, covered, paint);
    touched_.clear();
  }

 private:
  template <typename Paint>
  static void paint_run(int first, int last, double share, Paint&& paint) {
    constexpr double rounding = 1e-12;  // What the running sum leaves behind a shape.
    if (first >= last || share < rounding) return;
    paint(first, last, static_cast<float>(std::min(share, 1.0)));
  }
  void add_piece(int column, double x0, double x1, double gain);
  void merge_touched();

  int columns_;
  std::vector<double> height_, area_;  ///< What the edges in a column cover beyond it, and in it.
  std::vector<Columns> touched_;
};

/// A closed polygon. For a smooth shape, give so many vertices that its curves' sagittas are far
/// below a wavelength of light: then only the shape is seen.
class Outline {
 public:
  explicit Outline(const std::vector<Point>& vertices);

  double left() const { return left_; }
  double right() const { return right_; }
  double top() const { return top_; }
  double bottom() const { return bottom_; }
  double area_mm2() const { return area_; }

  /// Adds its edges in row `y`; false where it has none there.
  bool cover_row(const Grid& grid, int y, RowCoverage& coverage) const;

 private:
  struct Edge {
    Point from, to;
    double top() const { return std::min(from.y, to.y); }
    double bottom() const { return std::max(from.y, to.y); }
  };

  std::vector<Edge> edges_;  ///< By their tops.
  double tallest_ = 0;
  double left_ = 0, right_ = 0, top_ = 0, bottom_ = 0, area_ = 0;
};

/// Twice the signed area of a polygon is the sum of x_i y_i+1 - x_i+1 y_i; this is the area.
double signed_area_mm2(const std::vector<Point>& vertices);

}  // namespace glare
