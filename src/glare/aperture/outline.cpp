#include "glare/aperture/outline.h"

#include <utility>

namespace glare {

Outline::Outline(std::vector<Point> points) : points_(std::move(points)) {
  for (const Point& p : points_) {
    top_ = std::min(top_, p.y);
    bottom_ = std::max(bottom_, p.y);
  }
}

std::vector<Outline::Edge> Outline::edges_between(double top, double bottom) const {
  std::vector<Edge> edges;
  if (bottom_ < top || top_ > bottom) return edges;
  const Point* from = &points_.back();
  for (const Point& to : points_) {
    if (std::max(from->y, to.y) >= top && std::min(from->y, to.y) <= bottom)
      edges.push_back({*from, to});
    from = &to;
  }
  return edges;
}

void RowCoverage::add(std::span<const Outline::Edge> edges, int y) {
  const double per_mm = 1 / grid_.pixel, middle = 0.5 * grid_.size;
  for (const Outline::Edge& edge : edges) {
    // In pixels: columns from the left, and rows from this one's top.
    const Point from{edge.from.x * per_mm + middle, edge.from.y * per_mm + middle - y};
    const Point along = per_mm * (edge.to - edge.from);
    if (along.y == 0) continue;
    const double begin = std::clamp(-from.y / along.y, 0.0, 1.0);
    const double end = std::clamp((1 - from.y) / along.y, 0.0, 1.0);
    if (begin == end) continue;
    const auto [first, last] = std::minmax(begin, end);
    add_within_row(from + first * along, from + last * along);
  }
}

void RowCoverage::add_within_row(Point from, Point to) {
  const double height = to.y - from.y;
  const auto [least, most] = std::minmax(from.x, to.x);
  const double left = std::clamp<double>(least, 0, grid_.size);
  const double right = std::clamp<double>(most, 0, grid_.size);
  const int first = static_cast<int>(left), last = static_cast<int>(right);
  for (int x = first; x <= last; ++x) {
    const double enters = std::max<double>(left, x), leaves = std::min<double>(right, x + 1.0);
    const double part = first == last ? height : height * (leaves - enters) / (right - left);
    const double beside = 0.5 * (enters + leaves) - x;  // Of the pixel, left of the edge.
    sums_[x] += part * (1 - beside);
    sums_[x + 1] += part * beside;
  }
  touched_.first = std::min(touched_.first, first);
  touched_.last = std::max(touched_.last, last + 2);
}

}  // namespace glare
