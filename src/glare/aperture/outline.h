// Exact areas of closed outlines: the share of each pixel that lies inside. Internal.
#pragma once

#include <span>
#include <vector>

#include "glare/aperture/coverage.h"

namespace glare {

/// A closed outline of straight edges, from each point to the next and from the last to the first,
/// in millimetres from the pupil's centre. It doesn't cross itself.
class Outline {
 public:
  explicit Outline(std::vector<Point> points);

  double top() const { return top_; }
  double bottom() const { return bottom_; }

  /// An edge, by its end points.
  struct Edge {
    Point from, to;
  };
  /// The edges that touch the rows between the heights `top` and `bottom`, in their order.
  std::vector<Edge> edges_between(double top, double bottom) const;

 private:
  std::vector<Point> points_;
  double top_ = 1e30, bottom_ = -1e30;
};

/// The shares of the pixels of one row. The signed area to the right of each edge is added up, as
/// in Green's theorem, so that the shares are exact for any outline that lies within the picture;
/// what is left or right of it is moved to the border.
class RowCoverage {
 public:
  explicit RowCoverage(const Grid& grid)
      : grid_(grid), sums_(static_cast<std::size_t>(grid.size) + 2), touched_{grid.size, 0} {}

  /// Adds all edges of an outline, or those that touch row `y`.
  void add(std::span<const Outline::Edge> edges, int y);

  /// Calls `use(column, share)` for each column that may not be free, and begins anew.
  template <typename Use>
  void take(const Use& use) {
    double sum = 0;
    for (int x = touched_.first; x < touched_.last; ++x) {
      sum += sums_[x];
      sums_[x] = 0;
      if (x < grid_.size) use(x, static_cast<float>(std::min(std::abs(sum), 1.0)));
    }
    touched_ = {grid_.size, 0};
  }

 private:
  void add_within_row(Point from, Point to);

  Grid grid_;
  std::vector<double> sums_;
  Columns touched_;
};

}  // namespace glare
