#include "glare/io/photo/curve.h"

#include <algorithm>
#include <cmath>

namespace glare::photo {

namespace {

/// Adds, at each pixel, by how much the area right of a straight piece within row `y` grows from
/// the pixel on its left to it. `height` is signed: the way down of the piece within the row.
void add_piece(std::span<float> row, double x0, double x1, double height) {
  if (x0 > x1) std::swap(x0, x1);
  const auto width = static_cast<std::ptrdiff_t>(row.size());
  const auto add = [&](std::ptrdiff_t column, double value) {
    if (column < width)
      row[static_cast<std::size_t>(std::max<std::ptrdiff_t>(column, 0))] +=
          static_cast<float>(value);
  };
  const auto first = static_cast<std::ptrdiff_t>(std::floor(x0));
  const auto last = static_cast<std::ptrdiff_t>(std::floor(x1));
  for (std::ptrdiff_t column = first; column <= last; ++column) {
    const double left = std::max(x0, static_cast<double>(column));
    const double right = std::min(x1, static_cast<double>(column + 1));
    const double share = x1 > x0 ? height * (right - left) / (x1 - x0) : height;
    const double covered = static_cast<double>(column + 1) - 0.5 * (left + right);
    add(column, share * covered);
    add(column + 1, share * (1 - covered));
  }
}

void add_edge(Image<float>& growth, const Place& from, const Place& to) {
  const double sense = from[1] < to[1] ? 1 : -1;
  const Place& top = sense > 0 ? from : to;
  const Place& bottom = sense > 0 ? to : from;
  if (top[1] == bottom[1]) return;
  const double slope = (bottom[0] - top[0]) / (bottom[1] - top[1]);
  const int first = std::clamp(static_cast<int>(std::floor(top[1])), 0, growth.height());
  const int last = std::clamp(static_cast<int>(std::ceil(bottom[1])), 0, growth.height());
  for (int y = first; y < last; ++y) {
    const double y0 = std::max<double>(top[1], y), y1 = std::min<double>(bottom[1], y + 1);
    if (y1 <= y0) continue;
    add_piece(growth.row(y), top[0] + slope * (y0 - top[1]), top[0] + slope * (y1 - top[1]),
              sense * (y1 - y0));
  }
}

}  // namespace

std::vector<Place> smooth_closed_curve(std::span<const Place> points, int parts) {
  std::vector<Place> curve;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Place &a = points[(i + n - 1) % n], &b = points[i], &c = points[(i + 1) % n],
                &d = points[(i + 2) % n];
    for (int part = 0; part < parts; ++part) {
      const double t = static_cast<double>(part) / parts;
      Place p;
      for (std::size_t k = 0; k < 2; ++k)
        p[k] = b[k] + 0.5 * t *
                          (c[k] - a[k] +
                           t * (2 * a[k] - 5 * b[k] + 4 * c[k] - d[k] +
                                t * (3 * (b[k] - c[k]) + d[k] - a[k])));
      curve.push_back(p);
    }
  }
  return curve;
}

Image<float> covered_area(std::span<const Place> polygon, int width, int height) {
  Image<float> image(width, height);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    add_edge(image, polygon[i], polygon[(i + 1) % polygon.size()]);
  for (int y = 0; y < height; ++y) {
    double sum = 0;
    for (float& value : image.row(y)) {
      sum += value;
      value = static_cast<float>(std::clamp(std::abs(sum), 0.0, 1.0));
      if (value < 1e-5f) value = 0;  // What is left of the rounding of a row's sum.
      if (value > 1 - 1e-5f) value = 1;
    }
  }
  return image;
}

}  // namespace glare::photo
