#include "glare/aperture/eye/particle_layer.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "glare/aperture/eye/small_shapes.h"
#include "glare/aperture/eye/split_mix.h"
#include "glare/base/error.h"

namespace glare {

namespace {

// A particle's drift is the sum of two sines of time along each axis.
constexpr double min_period_s[2] = {5, 9}, max_period_s[2] = {9, 17};

/// Amplitude of a sine whose speed, with another sine's and along both axes, gives the drift's
/// root mean square.
double drift_amplitude(double drift_mm_per_s, double period_s) {
  return drift_mm_per_s / std::numbers::sqrt2 * period_s / (2 * std::numbers::pi);
}

double max_drift(double drift_mm_per_s) {
  return std::numbers::sqrt2 * (drift_amplitude(drift_mm_per_s, max_period_s[0]) +
                                drift_amplitude(drift_mm_per_s, max_period_s[1]));
}

double drift_along_axis(double drift_mm_per_s, double time_s, SplitMix& random) {
  double sum = 0;
  for (int i = 0; i < 2; ++i) {
    const double period_s = random.between(min_period_s[i], max_period_s[i]);
    const double cycles = time_s / period_s + random.between(0, 1);
    sum += drift_amplitude(drift_mm_per_s, period_s) *
           std::sin(2 * std::numbers::pi * (cycles - std::floor(cycles)));
  }
  return sum;
}

Disc random_disc(const MediumParticles& p, Point corner, double time_s, SplitMix& random) {
  const double x = corner.x + random.between(0, 1), y = corner.y + random.between(0, 1);
  const double diameter_mm = 1e-3 * p.diameter_um * std::exp(p.diameter_spread * random.normal());
  Disc disc{static_cast<float>(x), static_cast<float>(y), static_cast<float>(0.5 * diameter_mm)};
  if (p.drift_mm_per_s > 0) {
    disc.x = static_cast<float>(x + drift_along_axis(p.drift_mm_per_s, time_s, random));
    disc.y = static_cast<float>(y + drift_along_axis(p.drift_mm_per_s, time_s, random));
  }
  return disc;
}

/// A seed for the square millimetre at (x, y).
std::uint64_t cell_seed(std::uint64_t seed, int x, int y) {
  const auto column = static_cast<std::uint64_t>(x + 0x8000);
  const auto row = static_cast<std::uint64_t>(y + 0x8000);
  return SplitMix(seed ^ SplitMix(row << 32 | column).next()).next();
}

/// Adds the shares that `disc` covers of row `y` to `cover`, the columns inside `open`.
void cover_row(const Disc& disc, const Grid& grid, int y, Columns open, std::vector<float>& cover) {
  const double r = disc.radius, top = grid.edge(y) - disc.y, bottom = top + grid.pixel;
  if (top >= r || bottom <= -r) return;
  const Columns touched = grid.touching(disc.x - r, disc.x + r);
  const int first = std::max(touched.first, open.first), last = std::min(touched.last, open.last);
  if (first >= last) return;
  const DiscRow disc_row(r, top, bottom);
  const double per_pixel = 1 / (grid.pixel * grid.pixel);
  double left = disc_row.area_to(grid.edge(first) - disc.x);
  for (int x = first; x < last; ++x) {
    const double right = disc_row.area_to(grid.edge(x + 1) - disc.x);
    cover[x - open.first] += static_cast<float>((right - left) * per_pixel);
    left = right;
  }
}

}  // namespace

ParticleLayer::ParticleLayer(const ParticleParameters& parameters, std::uint64_t seed,
                             double time_s, double radius_mm) {
  require_valid(parameters);
  if (!std::isfinite(time_s)) throw OptionError("eye: the time is not a finite number of seconds");
  const MediumParticles* particles[] = {&parameters.cornea, &parameters.lens, &parameters.vitreous};
  SplitMix seeds(seed);
  for (int i = 0; i < medium_count; ++i)
    media_[i] = place(*particles[i], seeds.next(), time_s, radius_mm);
}

// Each square millimetre has its own random numbers, so that a pupil that widens keeps its
// particles.
ParticleLayer::Medium ParticleLayer::place(const MediumParticles& particles, std::uint64_t seed,
                                           double time_s, double radius_mm) {
  Medium medium;
  if (particles.number_per_mm2 == 0) return medium;
  const int reach = static_cast<int>(std::ceil(radius_mm + max_drift(particles.drift_mm_per_s)));
  for (int y = -reach; y < reach; ++y)
    for (int x = -reach; x < reach; ++x) {
      SplitMix random(cell_seed(seed, x, y));
      const int count = static_cast<int>(particles.number_per_mm2 + random.between(0, 1));
      for (int i = 0; i < count; ++i) {
        const Point corner{static_cast<double>(x), static_cast<double>(y)};
        const Disc disc = random_disc(particles, corner, time_s, random);
        if (std::hypot(disc.x, disc.y) <= radius_mm + disc.radius) medium.discs.push_back(disc);
      }
    }
  const auto place_of = [](const Disc& disc) { return std::pair(disc.y, disc.x); };
  std::ranges::sort(medium.discs, {}, place_of);
  for (const Disc& disc : medium.discs)
    medium.max_radius = std::max(medium.max_radius, disc.radius);
  return medium;
}

void ParticleLayer::draw_row(const Grid& grid, int y, Columns open, std::span<float> row) const {
  if (open.first >= open.last) return;
  std::vector<float> cover(static_cast<std::size_t>(open.last - open.first));
  for (const Medium& medium : media_) {
    const auto top = static_cast<float>(grid.edge(y) - medium.max_radius);
    const auto bottom = static_cast<float>(grid.edge(y + 1) + medium.max_radius);
    auto disc = std::ranges::lower_bound(medium.discs, top, {}, &Disc::y);
    for (; disc != medium.discs.end() && disc->y <= bottom; ++disc)
      cover_row(*disc, grid, y, open, cover);
  }
  float* const opened = row.data() + open.first;
  for (std::size_t i = 0; i < cover.size(); ++i) opened[i] *= 1 - std::clamp(cover[i], 0.0f, 1.0f);
}

}  // namespace glare
