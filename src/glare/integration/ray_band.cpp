#include "glare/integration/ray_band.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "glare/base/units.h"
#include "glare/integration/box_interpolation.h"
#include "glare/integration/interpolation_table.h"
#include "glare/integration/vector_loops.h"

namespace glare {

namespace {

/// Distances from place to place in a pixel, from ray to ray at a band's outer edge, and from step
/// to step of the logarithm there, in periods of the finest detail at the shortest wavelength,
/// lambda / extent. docs/performance.md has the errors and times of others.
constexpr double kPlaces = 0.375, kRays = 0.48, kLogSteps = 0.32;

/// Near the axis, up to as many cycles of the finest detail, the pattern is steep, and more rays
/// cost little.
constexpr double kNearAxis_cycles = 90, kRaysNearAxis = 0.25;

/// Steps of the convolution in periods of the detail that it must carry, and the longest; only
/// bands with as much detail as this, in cycles per unit of the logarithm, are worth fewer steps.
constexpr double kCoarseSteps = 0.3, kLongestStep = 0.01, kLongestCoarseStep = 0.002,
                 kMuchDetail = 150;

/// Distances depend on this wavelength, and on the range's shortest only where that is shorter: so
/// a part of the range is integrated at steps like the whole's.
constexpr double kShortestSeen_nm = 380;

double shortest_mm(const WavelengthRange& range) {
  return std::min(range.lo_nm, kShortestSeen_nm) * kMmPerNm;
}

/// Samples of the far field, at the longest wavelength, that are left to the innermost part. Light
/// of one wavelength has dark nulls, which no other light fills and near which every error counts;
/// its sum over wavenumbers is short.
constexpr double kInner_samples = 12, kInnerOfOneWavelength_samples = 96;
constexpr double kOneWavelength_nm = 2;

/// Smooth, for places at 2.7 a period.
constexpr WindowedSinc kPlacesKernel{8, 6};

double longest_extent_mm(const FarField& field) {
  return std::max(field.extent_x_mm, field.extent_y_mm);
}

std::vector<float> mean_weights(int per_pixel, int reach) {
  static const BoxInterpolation interpolation(kPlacesKernel);
  const std::array<double, 2> edges = {-0.5 * per_pixel, 0.5 * per_pixel};
  std::vector<BoxWeights> box;
  interpolation.weights_between(edges, box);
  std::vector<float> weights(static_cast<std::size_t>(2 * reach + 1), 0.0f);
  for (std::size_t i = 0; i < box[0].weights.size(); ++i) {
    const int place = box[0].first + static_cast<int>(i) + reach;
    if (place >= 0 && place <= 2 * reach)
      weights[static_cast<std::size_t>(place)] = box[0].weights[i];
  }
  return weights;
}

bool is_near_axis(double extent_mm, double last_rad, const WavelengthRange& range) {
  return last_rad * extent_mm < kNearAxis_cycles * shortest_mm(range);
}

/// The step of the logarithm that resolves all detail up to a major coordinate.
double finest_log_step(const FarField& field, double last_rad, const WavelengthRange& range) {
  return std::min(kLongestStep,
                  kLogSteps * shortest_mm(range) / (longest_extent_mm(field) * last_rad));
}

/// What is the same for all bands of a sector.
struct SectorPixels {
  Sector sector;
  int last_px, across_px;
  double minor_extent_mm;
};

std::array<SectorPixels, 2> sectors(const FarField& field, const PixelGrid& grid) {
  return {{{Sector::y_major, grid.center_y(), grid.center_x(), field.extent_x_mm},
           {Sector::x_major, grid.center_x(), grid.center_y(), field.extent_y_mm}}};
}

/// Fewer steps than by this factor would gain nothing.
constexpr double kWorthwhile = 1.3;

/// Whether a ray is sampled densely enough where it crosses the field's own rows of the major
/// coordinate: it goes through detail of both extents, and an opening much longer along the minor
/// coordinate has more of it than rows. `RaySamples` averages only such rays.
bool is_dense_by_row(const FarField& field, const RayBand& band) {
  constexpr double kMost_cycles = 0.7;  // Per row; what is beyond 1/2 is the corners', and dim.
  const bool x_major = band.sector == Sector::x_major;
  const double major_mm = x_major ? field.extent_x_mm : field.extent_y_mm;
  const double minor_mm = x_major ? field.extent_y_mm : field.extent_x_mm;
  const double bin_per_mm = x_major ? field.bin_x_per_mm : field.bin_y_per_mm;
  const double slope = std::min(1.0, 2.0 * band.across_px / band.end_px);
  return (major_mm + slope * minor_mm) * bin_per_mm <= kMost_cycles;
}

void set_log_steps(const FarField& field, const WavelengthRange& range,
                   const std::function<double(double)>& cutoff, RayBand& band) {
  const double finest = finest_log_step(field, band.last_rad, range);
  const double bandwidth = kLogSteps / finest;
  double coarse = finest;
  if (bandwidth > kMuchDetail && is_dense_by_row(field, band))
    coarse =
        std::clamp(kCoarseSteps / cutoff(bandwidth), finest, std::max(finest, kLongestCoarseStep));
  band.decimation =
      coarse < kWorthwhile * finest ? 1 : static_cast<int>(std::ceil(coarse / finest));
  band.fine_step = band.decimation == 1 ? finest : coarse / band.decimation;
}

/// Sets what depends on where the band begins.
void set_begin(const SubPixels& sub, int begin_px, RayBand& band) {
  const double first = begin_px * sub.per_pixel - sub.reach;
  const double across = std::min(begin_px, band.across_px) * sub.per_pixel + sub.reach;
  constexpr int kMargin = InterpolationTable<12>::kTaps / 2 + 1;
  band.begin_px = begin_px;
  band.first_rad = first * sub.pitch_rad;
  band.rays_each_side = static_cast<int>(std::ceil(across / first / band.ray_step)) + kMargin;
}

/// How far in a band reaches: an octave, and less where its rays would take too much memory; all
/// the way where little would be left.
int begin_of_band(const RayBand& band, const SubPixels& sub, int begin_px) {
  const double rays = 2 / band.ray_step;
  const double rows = kMostRayValues / (3 * rays);
  const double share = std::exp(-rows * band.fine_step * band.decimation);
  const int nearest = static_cast<int>(std::ceil(band.end_px * std::max(0.5, share)));
  const int begin = std::min(nearest, band.end_px - 1);
  return begin < begin_px + begin_px / 2 + sub.reach / sub.per_pixel && share < 0.5
             ? begin_px
             : std::max(begin, begin_px);
}

}  // namespace

SubPixels sub_pixels(const FarField& field, const PixelGrid& grid, const WavelengthRange& range) {
  const double farthest_rad = kPlaces * shortest_mm(range) / longest_extent_mm(field);
  SubPixels sub;
  sub.per_pixel = std::max(1, static_cast<int>(std::ceil(grid.pitch_rad / farthest_rad)));
  sub.pitch_rad = grid.pitch_rad / sub.per_pixel;
  sub.reach = sub.per_pixel / 2 + kPlacesKernel.taps / 2;
  sub.weights = mean_weights(sub.per_pixel, sub.reach);
  return sub;
}

int first_ring_px(const FarField& field, const SubPixels& sub, const WavelengthRange& range,
                  double light_width_nm) {
  const double samples =
      light_width_nm < kOneWavelength_nm ? kInnerOfOneWavelength_samples : kInner_samples;
  const double bin_per_mm = std::max(field.bin_x_per_mm, field.bin_y_per_mm);
  const double places = samples * range.hi_nm * kMmPerNm * bin_per_mm / sub.pitch_rad + sub.reach;
  return static_cast<int>(std::ceil(places / sub.per_pixel));
}

double finest_log_step(const FarField& field, const PixelGrid& grid, const SubPixels& sub,
                       const WavelengthRange& range) {
  const double last = std::max(grid.center_x(), grid.center_y()) * sub.per_pixel + sub.reach;
  // A whole number of fine steps makes a coarse one: so they may be shorter, by this at most.
  return kWorthwhile / 2 * finest_log_step(field, last * sub.pitch_rad, range);
}

std::vector<RayBand> ray_bands(const FarField& field, const PixelGrid& grid, const SubPixels& sub,
                               const WavelengthRange& range, int begin_px,
                               const std::function<double(double)>& cutoff) {
  std::vector<RayBand> bands;
  for (const SectorPixels& pixels : sectors(field, grid)) {
    for (int end = pixels.last_px + 1; end > begin_px; end = bands.back().begin_px) {
      RayBand band{};
      band.sector = pixels.sector;
      band.end_px = end;
      band.across_px = pixels.across_px;
      band.last_rad = ((end - 1) * sub.per_pixel + sub.reach) * sub.pitch_rad;
      band.near_axis = is_near_axis(longest_extent_mm(field), band.last_rad, range);
      band.ray_step = (band.near_axis ? kRaysNearAxis : kRays) * shortest_mm(range) /
                      (pixels.minor_extent_mm * band.last_rad);
      set_log_steps(field, range, cutoff, band);
      set_begin(sub, begin_of_band(band, sub, begin_px), band);
      bands.push_back(band);
    }
  }
  return bands;
}

std::uint64_t ring_bytes(double open_side_mm, const PixelGrid& grid, const WavelengthRange& range,
                         int threads) {
  const double cycles = (std::max(grid.center_x(), grid.center_y()) + 1) * grid.pitch_rad *
                        open_side_mm / shortest_mm(range);
  // The outermost octave's rays at their densest, with what interpolation takes in at the borders,
  // and the inner ones', of both sectors; or what is held at a time.
  const double rays = 2.2 * cycles / kRaysNearAxis + 64, rows = 0.7 * cycles / kLogSteps + 96;
  const double values = std::min(2.7 * 3 * rays * rows, 1.25 * kMostRayValues);
  // A tile of rays: its samples, and the buffers of its transforms; a tile of pixels.
  const double steps = 1.6 * cycles / kLogSteps + 256, samples = 8 * cycles + 256;
  const double tile = (7 * steps * kRaysPerBlock + 4 * samples * kRaysPerBlock) + 3e5;
  return static_cast<std::uint64_t>(sizeof(float) * (values + threads * tile));
}

}  // namespace glare
