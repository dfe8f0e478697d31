#include "glare/aperture/eye/lens_layer.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "glare/aperture/eye/split_mix.h"

namespace glare {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double end_width = 0.5;  // Of a suture's branch, relative to its width at the pole.

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

/// Mean of cos over an interval of `width` radians, relative to its value at the middle.
double box_mean(double width) {
  const double half = 0.5 * width;
  return std::abs(half) < 1e-4 ? 1 : std::sin(half) / half;
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
  log_step_ = log_range / count;
  for (int i = 0; i < count; ++i) {
    Ring ring{inner * std::exp(i * log_step_), inner * std::exp((i + 1) * log_step_), 0, 0};
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

double LensLayer::Ring::weight(double radius) const {
  constexpr double soft_share = 0.15;  // Of the ring's width, at each edge.
  const double from_edge = std::min(radius - inner, outer - radius);
  return smooth_step(from_edge / (soft_share * (outer - inner)));
}

void LensLayer::draw_row(const Grid& grid, int y, Columns open, std::span<float> row) const {
  if (parameters_.fibre_modulation > 0) draw_fibre_row(grid, y, open, row);
  if (parameters_.suture_contrast > 0) draw_sutures(grid, y, open, row);
}

void LensLayer::draw_fibre_row(const Grid& grid, int y, Columns open, std::span<float> row) const {
  // Over 0.01 mm a radial grating's phase is a parabola to 1e-4 rad, and a ring's weight a line.
  constexpr double max_part_mm = 0.01;
  constexpr int max_part = 32;
  const int part = std::clamp(static_cast<int>(max_part_mm / grid.pixel), 1, max_part);
  const auto mean = static_cast<float>(1 - 0.5 * parameters_.fibre_modulation);
  for (int x = open.first; x < open.last; ++x) row[x] *= mean;

  const double centre = grid.centre(y);
  const auto half_chord = [&](double r) {
    return std::sqrt(std::max(r * r - centre * centre, 0.0));
  };
  const double outer = half_chord(rings_.back().outer), inner = half_chord(rings_.front().inner);
  int drawn = open.first;  // Where the two sides meet, they have a column in common.
  for (const Columns side : {grid.touching(-outer, -inner), grid.touching(inner, outer)}) {
    const Columns columns = both(side, {drawn, open.last});
    for (int x = columns.first; x < columns.last; x += part)
      draw_fibres(grid, centre, {x, std::min(x + part, columns.last)}, row);
    drawn = std::max(drawn, columns.last);
  }
}

// The phase is fibres * atan2(y, x), whose derivatives along x are -y / r^2 and 2 x y / r^4. A
// plane wave's mean over a square is its value at the centre times a sinc for each axis.
void LensLayer::draw_fibres(const Grid& grid, double y, Columns part, std::span<float> row) const {
  const double x = 0.5 * (grid.centre(part.first) + grid.centre(part.last - 1));
  const double squared = x * x + y * y;
  const int index =
      static_cast<int>(std::floor(std::log(std::sqrt(squared) / rings_.front().inner) / log_step_));
  if (index < 0 || index >= static_cast<int>(rings_.size())) return;
  const Ring& ring = rings_[index];

  const double h = grid.pixel, per_radian = ring.fibres * h / squared;
  const double first_order = -y * per_radian, second_order = 2 * x * y / squared * per_radian * h;
  const double mean = box_mean(first_order) * box_mean(x * per_radian);
  const double depth = 0.5 * parameters_.fibre_modulation * mean;
  const auto weight = [&](double at) { return ring.weight(std::sqrt(at * at + y * y)) * depth; };
  const int count = part.last - part.first;
  double amount = weight(grid.centre(part.first));
  const double growth = count > 1 ? (weight(grid.centre(part.last - 1)) - amount) / (count - 1) : 0;

  const double start = -0.5 * (count - 1);
  const double phase = ring.fibres * std::atan2(y, x) + ring.phase;
  auto wave = std::polar(1.0, phase + start * first_order + 0.5 * start * start * second_order);
  auto step = std::polar(1.0, first_order + (start + 0.5) * second_order);
  const auto bend = std::polar(1.0, second_order);
  const double per_mean = 1 / (1 - 0.5 * parameters_.fibre_modulation);
  const auto product = [](std::complex<double> a, std::complex<double> b) {
    return std::complex<double>(a.real() * b.real() - a.imag() * b.imag(),
                                a.real() * b.imag() + a.imag() * b.real());
  };
  for (int i = part.first; i < part.last; ++i) {
    row[i] *= static_cast<float>(std::max(1 - per_mean * amount * wave.real(), 0.0));
    wave = product(wave, step);
    step = product(step, bend);
    amount += growth;
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
