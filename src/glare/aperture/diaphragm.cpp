#include "glare/aperture/diaphragm.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye/split_mix.h"
#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/base/range_check.h"

namespace glare {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPicturePerDiameter = 1.04;
constexpr int kMaxPictureWidth = 65535;

void require_of_diaphragm(const std::string& name, double value, double low, double high) {
  require_in_range("diaphragm: " + name, value, low, high);
}

/// Width of the picture in pixels.
int picture_width(const DiaphragmParameters& p, double max_pixel_mm) {
  const double width_mm = diaphragm_picture_width_mm(p);
  require_of_diaphragm("max_pixel_mm", max_pixel_mm, width_mm / kMaxPictureWidth,
                       p.diameter_mm / 16);
  // Slightly less than the quotient, so that a width_mm / n given as max_pixel_mm gives n pixels.
  return static_cast<int>(std::ceil(width_mm / max_pixel_mm * (1 - 1e-12)));
}

/// Place of a direction on the unit circle: 0 is up, and it turns clockwise.
Point direction(double angle) { return {std::sin(angle), -std::cos(angle)}; }

// The opening.

/// Half of the angle that an edge's arc spans, as seen from the arc's centre.
double half_arc(const DiaphragmParameters& p) {
  return std::asin(std::min(p.roundness * std::sin(kPi / p.blade_count), 1.0));
}

/// Adds the points of the edge between the corners at angles `from` and `to`, without the last.
void add_edge(const DiaphragmParameters& p, double from, double to, double pixel,
              std::vector<Point>& points) {
  const double corner_radius = p.diameter_mm / 2;
  if (p.roundness == 0) {
    points.push_back(corner_radius * direction(from));
    return;
  }
  // Short enough that the arc bulges at most a millionth of a pixel beyond: step^2 / (8 radius).
  constexpr double kBulge = 1e-6;
  const double radius = corner_radius / p.roundness, half = half_arc(p);
  const double step = std::sqrt(8 * kBulge * pixel / radius);
  const int count = static_cast<int>(std::ceil(2 * half / step));
  const double middle = 0.5 * (from + to);
  const double offset = corner_radius * std::cos(kPi / p.blade_count) - radius * std::cos(half);
  for (int i = 0; i < count; ++i)
    points.push_back(offset * direction(middle) +
                     radius * direction(middle + half * (2.0 * i / count - 1)));
}

Outline opening(const DiaphragmParameters& p, double pixel) {
  std::vector<Point> points;
  const double turn = p.rotation_deg * kPi / 180, step = 2 * kPi / p.blade_count;
  for (int i = 0; i < p.blade_count; ++i)
    add_edge(p, turn + i * step, turn + (i + 1) * step, pixel, points);
  return Outline(std::move(points));
}

// Dust and scratches.

/// A place anywhere in a disc.
Point within(double radius, SplitMix& random) {
  const double distance = radius * std::sqrt(random.between(0, 1));
  return distance * direction(random.between(0, 2 * kPi));
}

/// A speck of an uneven outline: a circle with ripples of two to five to the turn.
Outline speck(const DiaphragmParameters& p, SplitMix& random) {
  constexpr int kPoints = 48;
  const Point centre = within(p.diameter_mm / 2, random);
  const double radius = p.dust_diameter_mm / 2 * random.between(0.5, 1.5);
  std::vector<double> ripples(kPoints, 1.0);
  for (int order = 2; order <= 5; ++order) {
    const double height = random.between(0, 0.3 / order), phase = random.between(0, 2 * kPi);
    for (int i = 0; i < kPoints; ++i)
      ripples[i] += height * std::cos(order * 2 * kPi * i / kPoints + phase);
  }
  std::vector<Point> points;
  for (int i = 0; i < kPoints; ++i)
    points.push_back(centre + radius * ripples[i] * direction(2 * kPi * i / kPoints));
  return Outline(std::move(points));
}

/// A scratch along a parabola, as wide as a parabola too.
Outline scratch(const DiaphragmParameters& p, SplitMix& random) {
  constexpr int kSteps = 24;
  const Point centre = within(p.diameter_mm / 2, random);
  const double angle = random.between(0, 2 * kPi);
  const Point along = direction(angle), across = direction(angle + kPi / 2);
  const double length = p.scratch_length_mm * random.between(0.5, 1.5);
  const double bow = length * random.between(-0.08, 0.08);
  std::vector<Point> points;
  for (int i = 0; i < 2 * kSteps; ++i) {  // There on one side, and back on the other.
    const bool back = i > kSteps;
    const double t = back ? 3 - 2.0 * i / kSteps : 2.0 * i / kSteps - 1;  // -1 to 1.
    const double hill = 1 - t * t;
    const double aside = bow * hill + (back ? -0.5 : 0.5) * p.scratch_width_mm * hill;
    points.push_back(centre + 0.5 * length * t * along + aside * across);
  }
  return Outline(std::move(points));
}

/// What is on the glass; how many specks there are doesn't move the scratches.
std::vector<Outline> marks(const DiaphragmParameters& p) {
  std::vector<Outline> marks;
  SplitMix dust(p.seed), scratches(~p.seed);
  for (int i = 0; i < p.dust_count; ++i) marks.push_back(speck(p, dust));
  for (int i = 0; i < p.scratch_count; ++i) marks.push_back(scratch(p, scratches));
  return marks;
}

/// Draws the rows from `first` to before `last`.
void draw_rows(const Grid& grid, const Outline& opening, const std::vector<Outline>& marks,
               int first, int last, Image<float>& picture) {
  RowCoverage coverage(grid.size);
  for (int y = first; y < last; ++y) {
    const auto row = picture.row(y);
    if (!opening.cover_row(grid, y, coverage)) continue;
    coverage.paint([&](int begin, int end, float share) {
      std::fill(row.begin() + begin, row.begin() + end, share);
    });
    for (const Outline& mark : marks)
      if (mark.cover_row(grid, y, coverage))
        coverage.paint([&](int begin, int end, float share) {
          for (int x = begin; x < end; ++x) row[static_cast<std::size_t>(x)] *= 1 - share;
        });
  }
}

}  // namespace

void require_valid(const DiaphragmParameters& p) {
  require_of_diaphragm("diameter_mm", p.diameter_mm, 0.1, 200);
  require_of_diaphragm("blade_count", p.blade_count, 3, 32);
  require_of_diaphragm("roundness", p.roundness, 0, 1);
  require_of_diaphragm("rotation_deg", p.rotation_deg, -360, 360);
  require_of_diaphragm("dust_count", p.dust_count, 0, 10000);
  require_of_diaphragm("dust_diameter_mm", p.dust_diameter_mm, 0.001, 5);
  require_of_diaphragm("scratch_count", p.scratch_count, 0, 1000);
  require_of_diaphragm("scratch_length_mm", p.scratch_length_mm, 0.01, 200);
  require_of_diaphragm("scratch_width_mm", p.scratch_width_mm, 0.0001, 1);
}

double diaphragm_picture_width_mm(const DiaphragmParameters& parameters) {
  return kPicturePerDiameter * parameters.diameter_mm;
}

double diaphragm_area_mm2(const DiaphragmParameters& p) {
  const double corner_radius = p.diameter_mm / 2;
  const double polygon =
      0.5 * p.blade_count * corner_radius * corner_radius * std::sin(2 * kPi / p.blade_count);
  if (p.roundness == 0) return polygon;
  const double radius = corner_radius / p.roundness, arc = 2 * half_arc(p);
  return polygon + 0.5 * p.blade_count * radius * radius * (arc - std::sin(arc));
}

Aperture draw_diaphragm(const DiaphragmParameters& parameters, double max_pixel_mm, int threads,
                        const ProgressCallback& progress) {
  require_valid(parameters);
  constexpr int kRowsPerTask = 32;
  const int size = picture_width(parameters, max_pixel_mm);
  Aperture aperture{Image<float>(size, size), diaphragm_picture_width_mm(parameters)};
  const Grid grid{size, aperture.pixel_mm()};
  const Outline open = opening(parameters, grid.pixel);
  const std::vector<Outline> on_glass = marks(parameters);
  const auto draw_task = [&](int task) {
    draw_rows(grid, open, on_glass, task * kRowsPerTask, std::min(size, (task + 1) * kRowsPerTask),
              aperture.transmittance);
  };
  parallel_for((size + kRowsPerTask - 1) / kRowsPerTask, threads, draw_task, progress);
  return aperture;
}

}  // namespace glare
