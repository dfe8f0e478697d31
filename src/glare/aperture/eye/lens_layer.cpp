#include "glare/aperture/eye/lens_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glare/aperture/eye/split_mix.h"

namespace glare {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int max_part = 128;      // Pixels of a row that are drawn as one.
constexpr double end_width = 0.5;  // Of a suture's branch, relative to its width at the pole.

/// Mean of cos over an interval of `width` radians, relative to its value at the middle.
double box_mean(double width) {
  const double half = 0.5 * width, z = half * half;
  // The series, to 3e-8.
  if (z < 1) return 1 - z / 6 * (1 - z / 20 * (1 - z / 42 * (1 - z / 72)));
  return std::sin(half) / half;
}

/// cos of 2 pi `turns`, for up to some thousand turns, to 4e-6: Taylor's series of the sine.
float cosine_of_turns(float turns) {
  constexpr float to_whole =
      12582912;  // 1.5 * 2^23: what is added to it is rounded to whole numbers.
  const float whole = (turns + to_whole) - to_whole;
  const float v = 0.25f - std::abs(turns - whole), z = v * v;  // cos(2 pi t) = sin(2 pi (1/4 - t)).
  return v *
         (6.2831853f + z * (-41.341702f + z * (81.605249f + z * (-76.705860f + z * 42.058694f))));
}

Columns both(Columns a, Columns b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

}  // namespace

LensLayer::LensLayer(const LensParameters& parameters, std::uint64_t seed)
    : parameters_(parameters) {
  require_valid(parameters);
  SplitMix random(seed ^ 0x6c656e73);  // "lens"
  const double inner = parameters.fibre_zone_inner_mm;
  const double log_range = std::log(parameters.fibre_zone_outer_mm / inner);
  const int count = std::max(
      1, static_cast<int>(std::lround(log_range / std::log1p(parameters.fibre_pitch_variation))));
  const double log_step = log_range / count;  // Between neighbouring rings' radii.
  for (int i = 0; i < count; ++i) {
    Ring ring{inner * std::exp(i * log_step), inner * std::exp((i + 1) * log_step), 0, 0};
    ring.fibres = std::round(pi * (ring.inner + ring.outer) / (1e-3 * parameters.fibre_pitch_um));
    ring.phase = random.between(-pi, pi);
    rings_.push_back(ring);
  }

  constexpr double direction_spread = 0.25;
  const double turn = random.between(0, 2 * pi), radius = 0.5e-3 * parameters.suture_width_um;
  for (int i = 0; i < parameters.suture_branches; ++i) {
    const double place = i + random.between(-direction_spread, direction_spread);
    const double angle = turn + 2 * pi * place / parameters.suture_branches;
    const double length = parameters.suture_length_mm * random.between(0.7, 1);
    sutures_.emplace_back(length * Point{std::cos(angle), std::sin(angle)}, radius);
  }
}

void LensLayer::draw_row(const Grid& grid, int y, Columns open, std::span<float> row) const {
  if (parameters_.fibre_modulation > 0) draw_fibre_row(grid, y, open, row);
  if (parameters_.suture_contrast > 0) draw_sutures(grid, y, open, row);
}

void LensLayer::draw_fibre_row(const Grid& grid, int y, Columns open, std::span<float> row) const {
  // Over 0.04 mm a radial grating's phase is a cubic parabola to 1e-4 rad, the radius a
  // parabola to 1e-5 mm and the wave's mean over a pixel's square a line.
  constexpr double max_part_mm = 0.04;
  const int part = std::clamp(static_cast<int>(max_part_mm / grid.pixel), 1, max_part);
  const auto mean = static_cast<float>(1 - 0.5 * parameters_.fibre_modulation);
  for (int x = open.first; x < open.last; ++x) row[x] *= mean;

  const double centre = grid.centre(y);
  const auto first_right_of = [&](double x) {  // Of the columns, by their centres.
    const double column = std::ceil(x / grid.pixel + 0.5 * (grid.size - 1));
    return static_cast<int>(std::clamp<double>(column, open.first, open.last));
  };
  const auto half_chord = [&](double r) {
    return std::sqrt(std::max(r * r - centre * centre, 0.0));
  };
  for (const Ring& ring : rings_) {
    if (ring.outer <= std::abs(centre)) continue;
    const double inner = half_chord(ring.inner), outer = half_chord(ring.outer);
    const int middle = first_right_of(0);
    const Columns sides[] = {{first_right_of(-outer), std::min(first_right_of(-inner), middle)},
                             {std::max(first_right_of(inner), middle), first_right_of(outer)}};
    for (const Columns side : sides)
      for (int x = side.first; x < side.last; x += part)
        draw_fibres(ring, grid, centre, {x, std::min(x + part, side.last)}, row);
  }
}

// The phase is fibres * atan2(y, x), the imaginary part of log(x + i y), whose derivatives along x
// are -y / r^2, 2 x y / r^4 and 2 y (y^2 - 3 x^2) / r^6. A plane wave's mean over a square is its
// value at the centre times a sinc for each axis.
void LensLayer::draw_fibres(const Ring& ring, const Grid& grid, double y, Columns part,
                            std::span<float> row) const {
  const double x = 0.5 * (grid.centre(part.first) + grid.centre(part.last - 1));
  const double h = grid.pixel, squared = x * x + y * y, turns = ring.fibres / (2 * pi);
  const double first = -y * turns * h / squared;
  const double second = x * y * turns * (h / squared) * (h / squared);
  const double third =
      y * (y * y - 3 * x * x) / 3 * turns * (h / squared) * (h / squared) * (h / squared);
  const double phase = turns * std::atan2(y, x) + ring.phase / (2 * pi);

  const double per_mean = 1 / (1 - 0.5 * parameters_.fibre_modulation);
  const auto depth = [&](double at) {
    const double per_pixel = ring.fibres * h / (at * at + y * y);
    return per_mean * 0.5 * parameters_.fibre_modulation * box_mean(y * per_pixel) *
           box_mean(at * per_pixel);
  };
  const int count = part.last - part.first;
  const double start = -0.5 * (count - 1);
  const double left = depth(grid.centre(part.first)), right = depth(grid.centre(part.last - 1));
  const double growth = count > 1 ? (right - left) / (count - 1) : 0;

  // The share of the modulation at a radius: 0 at the ring's edges, without a step.
  constexpr double soft_share = 0.15;  // Of the ring's width, at each edge.
  const double soft = soft_share * (ring.outer - ring.inner);
  const double radius = std::sqrt(squared);
  const auto to_soft = static_cast<float>(1 / soft);
  const auto half_width = static_cast<float>(0.5 * (ring.outer - ring.inner));
  const auto from_middle = static_cast<float>(radius - 0.5 * (ring.inner + ring.outer));
  const auto r1 = static_cast<float>(x / radius * h);
  const auto r2 = static_cast<float>(0.5 * y * y / (squared * radius) * h * h);
  const auto p0 = static_cast<float>(phase - std::floor(phase)), p1 = static_cast<float>(first),
             p2 = static_cast<float>(second), p3 = static_cast<float>(third);
  const auto d0 = static_cast<float>(0.5 * (left + right)), d1 = static_cast<float>(growth);
  const auto start_at = static_cast<float>(start);
  float* const target = row.data() + part.first;
  // Absolute values rather than comparisons, so that the compiler computes several pixels at once.
  for (int i = 0; i < count; ++i) {
    const float t = start_at + static_cast<float>(i);
    const float wave = cosine_of_turns(p0 + t * (p1 + t * (p2 + t * p3)));
    const float from_edge = half_width - std::abs(from_middle + t * (r1 + t * r2));
    const float softness = from_edge * to_soft;
    const float share = 0.5f * (1 + std::abs(softness) - std::abs(softness - 1));  // From 0 to 1.
    const float weight = share * share * (3 - 2 * share);
    target[i] *=
        std::abs(1 - (d0 + t * d1) * weight * wave);  // It is not below 0, but for rounding.
  }
}

LensLayer::Suture::Suture(Point end, double radius)
    : Segment({}, end, radius, end_width * radius),
      slope_(end.x / end.y),
      half_width_(radius * std::sqrt(1 + slope_ * slope_)) {}

Columns LensLayer::Suture::touched(const Grid& grid, int y) const {
  if (bottom() < grid.edge(y) || top() > grid.edge(y + 1)) return {};
  const double at_top = slope_ * grid.edge(y), at_bottom = slope_ * grid.edge(y + 1);
  const double first = std::max(std::min(at_top, at_bottom) - half_width_, left());
  const double last = std::min(std::max(at_top, at_bottom) + half_width_, right());
  // A level branch's slope is infinite, or not a number in the row through it.
  return first <= last ? grid.touching(first, last) : grid.touching(left(), right());
}

void LensLayer::draw_sutures(const Grid& grid, int y, Columns open, std::span<float> row) const {
  Columns all{open.last, open.first};
  for (const Suture& suture : sutures_) {
    const Columns columns = both(suture.touched(grid, y), open);
    if (columns.first >= columns.last) continue;
    all = {std::min(all.first, columns.first), std::max(all.last, columns.last)};
  }
  if (all.first >= all.last) return;
  std::vector<float> covered(static_cast<std::size_t>(all.last - all.first));
  for (const Suture& suture : sutures_) {
    const Columns columns = both(suture.touched(grid, y), open);
    for (int x = columns.first; x < columns.last; ++x) {
      float& most = covered[x - all.first];
      most = std::max(most, suture.coverage({grid.centre(x), grid.centre(y)}, grid.pixel));
    }
  }
  const auto contrast = static_cast<float>(parameters_.suture_contrast);
  for (int x = all.first; x < all.last; ++x) row[x] *= 1 - contrast * covered[x - all.first];
}

}  // namespace glare
