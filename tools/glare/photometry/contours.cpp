#include "photometry/contours.h"

#include <cassert>
#include <cstddef>

namespace glare::tool {

namespace {

constexpr int kNone = -1;

/// The crossings of a level with a grid's edges, and which of them a line joins.
class Crossings {
 public:
  Crossings(std::span<const double> x, std::span<const double> y, const Image<float>& values,
            double level)
      : x_(x), y_(y), values_(values), level_(level) {
    joined_.assign(2 * values.values().size(), {kNone, kNone});
    for (int j = 0; j + 1 < values.height(); ++j)
      for (int i = 0; i + 1 < values.width(); ++i) join_in_cell(i, j);
  }

  std::vector<ContourLine> lines() {
    std::vector<ContourLine> lines;
    for (const bool from_ends : {true, false})  // Open lines first; what remains is closed.
      for (std::size_t edge = 0; edge < joined_.size(); ++edge)
        if (joined_[edge][0] != kNone && (!from_ends || joined_[edge][1] == kNone))
          lines.push_back(line_from(static_cast<int>(edge)));
    return lines;
  }

 private:
  bool inside(int i, int j) const { return values_(i, j) >= level_; }
  /// The edge from (i, j) to the right, or up.
  int across(int i, int j) const { return 2 * (j * values_.width() + i); }
  int upwards(int i, int j) const { return across(i, j) + 1; }

  void join(int a, int b) {
    for (const auto& [edge, other] : {std::array{a, b}, std::array{b, a}}) {
      auto& places = joined_[static_cast<std::size_t>(edge)];
      (places[0] == kNone ? places[0] : places[1]) = other;
    }
  }

  void join_in_cell(int i, int j) {
    const int low = across(i, j), high = across(i, j + 1), left = upwards(i, j),
              right = upwards(i + 1, j);
    const bool a = inside(i, j), b = inside(i + 1, j), c = inside(i + 1, j + 1),
               d = inside(i, j + 1);
    if (a != b && b != c && c != d) return join_in_saddle(i, j, {low, right, high, left});
    int ends[2], count = 0;
    if (a != b) ends[count++] = low;
    if (b != c) ends[count++] = right;
    if (c != d) ends[count++] = high;
    if (d != a) ends[count++] = left;
    if (count == 2) join(ends[0], ends[1]);
  }

  void join_in_saddle(int i, int j, const std::array<int, 4>& edges) {
    const double mean =
        (double{values_(i, j)} + values_(i + 1, j) + values_(i, j + 1) + values_(i + 1, j + 1)) / 4;
    // The middle belongs to the first corner and its opposite: the others are cut off; or not.
    const bool with_first = (mean >= level_) == inside(i, j);
    join(edges[0], edges[with_first ? 1 : 3]);
    join(edges[2], edges[with_first ? 3 : 1]);
  }

  std::array<double, 2> point_on(int edge) const {
    const int node = edge / 2, i = node % values_.width(), j = node / values_.width();
    const bool up = edge % 2 == 1;
    const double from = values_(i, j), to = up ? values_(i, j + 1) : values_(i + 1, j);
    const double share = (level_ - from) / (to - from);
    const auto at = [share](std::span<const double> axis, int k, bool along) {
      const auto n = static_cast<std::size_t>(k);
      return along ? axis[n] + share * (axis[n + 1] - axis[n]) : axis[n];
    };
    return {at(x_, i, !up), at(y_, j, up)};
  }

  /// Takes the line that begins at an edge.
  ContourLine line_from(int first) {
    ContourLine line;
    int before = kNone, edge = first;
    while (edge != kNone) {
      line.push_back(point_on(edge));
      auto& places = joined_[static_cast<std::size_t>(edge)];
      const int next = places[0] != before || before == kNone ? places[0] : places[1];
      places = {kNone, kNone};
      before = edge;
      edge = next;
      if (edge == first && line.size() > 2) {
        line.push_back(line.front());
        break;
      }
    }
    return line;
  }

  std::span<const double> x_, y_;
  const Image<float>& values_;
  double level_;
  std::vector<std::array<int, 2>> joined_;
};

}  // namespace

std::vector<ContourLine> contour_lines(std::span<const double> x, std::span<const double> y,
                                       const Image<float>& values, double level) {
  assert(static_cast<int>(x.size()) == values.width());
  assert(static_cast<int>(y.size()) == values.height());
  return Crossings(x, y, values, level).lines();
}

}  // namespace glare::tool
