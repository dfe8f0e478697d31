#include "glare/aperture/coverage.h"

#include <cassert>
#include <cstddef>

namespace glare {

void RowCoverage::add_piece(int column, double x0, double x1, double gain) {
  const double right_of_it = column + 1 - 0.5 * (x0 + x1);
  area_[column] += gain * right_of_it;
  height_[column] += gain;
}

void RowCoverage::add_edge(double x0, double y0, double x1, double y1) {
  const double gain = y0 - y1;
  if (gain == 0) return;
  x0 = std::clamp<double>(x0, 0, columns_);
  x1 = std::clamp<double>(x1, 0, columns_);
  const double low = std::min(x0, x1), high = std::max(x0, x1);
  const int first = static_cast<int>(low);
  const int last = std::min(static_cast<int>(high), columns_);
  if (first >= columns_) return;
  touched_.push_back({first, std::min(last + 1, columns_)});
  if (last == first) return add_piece(first, low, high, gain);
  const double gain_per_column = gain / (high - low);
  double x = low;
  for (int column = first; column <= last; ++column) {
    const double next = std::min<double>(column + 1, high);
    add_piece(column, x, next, gain_per_column * (next - x));
    x = next;
  }
}

void RowCoverage::merge_touched() {
  std::ranges::sort(touched_, {}, &Columns::first);
  std::size_t count = 0;
  for (const Columns& part : touched_)
    if (count > 0 && part.first <= touched_[count - 1].last)
      touched_[count - 1].last = std::max(touched_[count - 1].last, part.last);
    else
      touched_[count++] = part;
  touched_.resize(count);
}

double signed_area_mm2(const std::vector<Point>& vertices) {
  double twice = 0;
  Point last = vertices.back();
  for (const Point& vertex : vertices) {
    twice += last.x * vertex.y - vertex.x * last.y;
    last = vertex;
  }
  return 0.5 * twice;
}

Outline::Outline(const std::vector<Point>& vertices) {
  assert(vertices.size() >= 3);
  const double area = signed_area_mm2(vertices);
  area_ = std::abs(area);
  const auto [left, right] = std::ranges::minmax(vertices, {}, &Point::x);
  const auto [top, bottom] = std::ranges::minmax(vertices, {}, &Point::y);
  left_ = left.x;
  right_ = right.x;
  top_ = top.y;
  bottom_ = bottom.y;
  Point last = vertices.back();
  for (const Point& vertex : vertices) {
    // Upwards along what is covered to the right.
    const Edge edge = area > 0 ? Edge{last, vertex} : Edge{vertex, last};
    if (edge.from.y != edge.to.y) edges_.push_back(edge);
    tallest_ = std::max(tallest_, edge.bottom() - edge.top());
    last = vertex;
  }
  std::ranges::sort(edges_, {}, &Edge::top);
}

bool Outline::cover_row(const Grid& grid, int y, RowCoverage& coverage) const {
  const double row_top = grid.edge(y), row_bottom = grid.edge(y + 1);
  if (bottom_ <= row_top || top_ >= row_bottom) return false;
  const double middle = 0.5 * grid.size, per_pixel = 1 / grid.pixel;
  auto edge = std::ranges::lower_bound(edges_, row_top - tallest_, {}, &Edge::top);
  for (; edge != edges_.end() && edge->top() < row_bottom; ++edge) {
    if (edge->bottom() <= row_top) continue;
    const double slope = (edge->to.x - edge->from.x) / (edge->to.y - edge->from.y);
    const auto in_row = [&](Point end) -> Point {
      const double clamped = std::clamp(end.y, row_top, row_bottom);
      const double x = clamped == end.y ? end.x : edge->from.x + slope * (clamped - edge->from.y);
      return {x * per_pixel + middle, (clamped - row_top) * per_pixel};
    };
    const Point from = in_row(edge->from), to = in_row(edge->to);
    coverage.add_edge(from.x, from.y, to.x, to.y);
  }
  return true;
}

}  // namespace glare
