#include "shapes.h"

namespace headlamp {

double polygon(std::span<const Vec2> corners, Vec2 p) {
  double nearest = 1e30;
  bool inside = false;
  Vec2 a = corners.back();
  for (const Vec2& b : corners) {
    const double edge_x = b.x - a.x, edge_y = b.y - a.y, x = p.x - a.x, y = p.y - a.y;
    const double along =
        std::clamp((x * edge_x + y * edge_y) / (edge_x * edge_x + edge_y * edge_y), 0.0, 1.0);
    const double to_x = x - along * edge_x, to_y = y - along * edge_y;
    nearest = std::min(nearest, to_x * to_x + to_y * to_y);
    if ((a.y > p.y) != (b.y > p.y) && x < edge_x * y / edge_y) inside = !inside;
    a = b;
  }
  return inside ? -std::sqrt(nearest) : std::sqrt(nearest);
}

}  // namespace headlamp
