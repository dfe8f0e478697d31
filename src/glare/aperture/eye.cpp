// Lengths are in millimetres from the pupil's centre, x to the right and y down, until something is
// rasterised. Nothing but the rasteriser knows the pixel's size.
#include "glare/aperture/eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>
#include <vector>

#include "glare/base/error.h"

namespace glare {

namespace {

constexpr double picture_per_pupil = 1.04;
constexpr int max_picture_width = 65536;

// ---- Parameters -------------------------------------------------------------------------------

void require_in_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  char text[160];
  std::snprintf(text, sizeof text, "eye: %s is %g, expected %g to %g", name, value, low, high);
  throw OptionError(text);
}

void require_valid(const EyeParameters& p) {
  require_in_range("pupil_diameter_mm", p.pupil_diameter_mm, 1, 10);
  require_in_range("eyelash_count", p.eyelash_count, 0, 1000);
  require_in_range("eyelash_root_width_mm", p.eyelash_root_width_mm, 1e-6, 0.5);
  require_in_range("eyelash_reach", p.eyelash_reach, 0, 1);
  require_in_range("eyelash_fan_deg", p.eyelash_fan_deg, 0, 60);
}

/// Width of the picture in pixels.
int picture_width(double width_mm, double pupil_diameter_mm, double max_pixel_mm) {
  require_in_range("max_pixel_mm", max_pixel_mm, width_mm / max_picture_width,
                   pupil_diameter_mm / 16);
  // Slightly less than the quotient, so that a width_mm / n given as max_pixel_mm gives n pixels.
  return static_cast<int>(std::ceil(width_mm / max_pixel_mm * (1 - 1e-12)));
}

/// SplitMix64 (Steele, Lea, Flood 2014), because the standard library's distributions differ from
/// one implementation to the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  double between(double low, double high) {
    constexpr double per_step = 0x1p-53;
    return low + (high - low) * (static_cast<double>(next() >> 11) * per_step);
  }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

// ---- Where the lashes are ---------------------------------------------------------------------

struct Point {
  double x = 0, y = 0;
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }

/// A lash's axis is the quadratic Bezier curve root, bend, tip.
struct Eyelash {
  Point root, bend, tip;
  double root_width;
};

/// Sets the curve's middle point so that the lash bows sideways by `bow` of its length.
void bow(Eyelash& lash, double bow) {
  const Point along = lash.tip - lash.root;
  lash.bend = 0.5 * (lash.root + lash.tip) + 2 * bow * Point{along.y, -along.x};
}

/// A lash that grows at `side`, -1 to 1 from the pupil's left to its right.
Eyelash free_eyelash(const EyeParameters& p, double side, Random& random) {
  constexpr double lid_radius = 15, lid_clearance = 0.3, rows_depth = 0.8;
  const double radius = p.pupil_diameter_mm / 2;
  const double x = 0.95 * radius * side;
  const double lid = x * x / (2 * lid_radius) - radius - lid_clearance;
  const double turn = 0.45 * side + 0.55 * random.between(-1, 1);
  const double angle = turn * p.eyelash_fan_deg * std::numbers::pi / 180;

  Eyelash lash;
  lash.root = {x, lid - random.between(0, rows_depth)};
  const double reach = p.eyelash_reach * p.pupil_diameter_mm * random.between(0.7, 1.15);
  const double length = std::max(reach - radius - lash.root.y, 0.0);
  lash.tip = lash.root + length * Point{std::sin(angle), std::cos(angle)};
  lash.root_width = p.eyelash_root_width_mm * random.between(0.67, 1);
  bow(lash, random.between(-0.05, 0.05) + 0.02 * side);
  return lash;
}

/// Pulls the tip of `lash` to its neighbour's, as tears and mascara do.
void clump(Eyelash& lash, const Eyelash& neighbour, Random& random) {
  const Point beside{random.between(-0.2, 0.2), random.between(-0.5, 0.3)};
  lash.tip = neighbour.tip + beside;
  bow(lash, random.between(-0.04, 0.04));
}

std::vector<Eyelash> eyelashes(const EyeParameters& p) {
  constexpr double clumped_share = 0.2;
  Random random(p.seed);
  std::vector<Eyelash> lashes;
  for (int i = 0; i < p.eyelash_count; ++i) {
    const double place = i + random.between(0, 1);
    lashes.push_back(free_eyelash(p, 2 * place / p.eyelash_count - 1, random));
    const bool clumped = random.between(0, 1) < clumped_share;
    if (clumped && i > 0) clump(lashes[i], lashes[i - 1], random);
  }
  return lashes;
}

// ---- Pupil ------------------------------------------------------------------------------------

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

// ---- Rasteriser -------------------------------------------------------------------------------

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

double half_chord(double y, double r) { return std::sqrt(std::max(r * r - y * y, 0.0)); }

/// The columns of row `y` that the pupil touches, drawn; the others stay as they are.
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
  float coverage(Point centre, double pixel) const {
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
  explicit Hair(const Eyelash& lash) {
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

  /// Darkens row `y` of the picture inside `open`. `covered` is a row of zeros, and is left so.
  void draw_row(const Grid& grid, int y, Columns open, std::span<float> covered,
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

 private:
  static constexpr int segment_count = 48;

  /// Unites `segment` with what is covered, and returns the columns it may have touched.
  static Columns cover_row(const Segment& segment, const Grid& grid, int y, Columns open,
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

  std::vector<Segment> segments_;
  double top_ = 1e30, bottom_ = -1e30;
};

}  // namespace

Aperture draw_eye(const EyeParameters& parameters, double max_pixel_mm) {
  require_valid(parameters);
  Aperture eye;
  eye.width_mm = picture_per_pupil * parameters.pupil_diameter_mm;
  const int size = picture_width(eye.width_mm, parameters.pupil_diameter_mm, max_pixel_mm);
  eye.transmittance = Image<float>(size, size);

  const Grid grid{size, eye.width_mm / size};
  std::vector<Hair> hairs;
  for (const Eyelash& lash : eyelashes(parameters)) hairs.emplace_back(lash);
  std::vector<float> covered(size);
  for (int y = 0; y < size; ++y) {
    const std::span<float> row = eye.transmittance.row(y);
    const Columns open = draw_pupil_row(grid, y, parameters.pupil_diameter_mm / 2, row);
    for (const Hair& hair : hairs) hair.draw_row(grid, y, open, covered, row);
  }
  return eye;
}

}  // namespace glare
