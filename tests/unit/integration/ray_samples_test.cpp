#include "glare/integration/ray_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace glare {
namespace {

constexpr int kLast = 200;  ///< The last sample held, both ways.
constexpr double kBinX = 0.05, kBinY = 0.08;
constexpr double kStep = 0.004;  ///< Of the logarithm: less than a sample, at the last.

/// A pattern over kx and ky, band-limited, the same at -k as at k, and not at (-kx, ky).
double pattern(double kx, double ky) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return 2 + std::cos(kTurn * (0.11 * kx + 0.07 * ky)) + std::cos(kTurn * (0.03 * kx - 0.12 * ky));
}

/// As a far field holds it: of kx < 0 only what interpolation near the axis needs.
FarField sampled_pattern() {
  FarField field;
  field.first_kx = -20;
  field.first_ky = -kLast;
  field.bin_x_per_mm = kBinX;
  field.bin_y_per_mm = kBinY;
  field.extent_x_mm = 1 / (4 * kBinX);
  field.extent_y_mm = 1 / (4 * kBinY);
  field.intensity_mm2 = Image<float>(2 * kLast + 1, kLast + 21);
  for (int kx = field.first_kx; kx <= kLast; ++kx)
    for (int ky = -kLast; ky <= kLast; ++ky)
      field.intensity_mm2(ky - field.first_ky, kx - field.first_kx) =
          static_cast<float>(pattern(kx, ky));
  return field;
}

/// Rows from sample 30 to 170 of the major coordinate.
LogRows rows_of(Sector sector, int decimation) {
  const double bin = sector == Sector::x_major ? kBinX : kBinY;
  const double fine_step = kStep / decimation;
  return {std::log(30 * bin), fine_step, decimation,
          static_cast<int>(std::log(170.0 / 30) / kStep)};
}

/// Rays from one diagonal a little beyond to the other.
RayBand band_of(Sector sector, bool near_axis) {
  RayBand band{};
  band.sector = sector;
  const double samples = 1.1 / 40;  // The outermost of 40 each side.
  band.ray_step = samples * (sector == Sector::x_major ? kBinY / kBinX : kBinX / kBinY);
  band.rays_each_side = 40;
  band.near_axis = near_axis;
  return band;
}

/// What one fine step holds on a ray, by the pattern itself.
double expected_at(const RayBand& band, int ray, double log, double log_scale) {
  const double major = std::exp(log), minor = major * ray * band.ray_step;
  const double whitening = std::exp(RaySamples::kWhitening * (log - log_scale));
  return whitening * (band.sector == Sector::x_major ? pattern(major / kBinX, minor / kBinY)
                                                     : pattern(minor / kBinX, major / kBinY));
}

/// The largest error, as a share of the whitening, of all of a band's rays, tile by tile.
double worst_error(Sector sector, int decimation, bool near_axis) {
  const FarField field = sampled_pattern();
  const RayBand band = band_of(sector, near_axis);
  const LogRows rows = rows_of(sector, decimation);
  const RaySamples samples(field, band, rows);
  const DecimationFilter filter(decimation);
  std::vector<float> found(static_cast<std::size_t>(rows.count * RaySamples::kRaysPerTile));
  RaySamples::Workspace work;
  double worst = 0;
  for (int first = -40; first <= 40; first += RaySamples::kRaysPerTile) {
    samples.sample(first, work, found.data());
    for (int m = 0; m < rows.count; ++m)
      for (int i = 0; i < RaySamples::kRaysPerTile; ++i) {
        const double value = found[static_cast<std::size_t>(m * RaySamples::kRaysPerTile + i)];
        if (first + i > band.rays_each_side) {
          EXPECT_EQ(value, 0) << "beyond the last ray";
          continue;
        }
        const double log = rows.first_log_per_mm + m * rows.step();
        double sum = 0;
        for (int s = -filter.reach(); s <= filter.reach(); ++s)
          sum += filter.weight(s) *
                 expected_at(band, first + i, log + s * rows.fine_step, samples.log_scale_per_mm());
        const double whitening =
            std::exp(RaySamples::kWhitening * (log - samples.log_scale_per_mm()));
        worst = std::max(worst, std::abs(value - sum) / whitening);
      }
  }
  return worst;
}

// The pattern's waves have 8 samples a period and more either way, of amplitude 1. Kernels of
// twelve taps err by 1e-4 of each wave there, those of eight by a few times as much.

TEST(RaySamples, MeetThePatternInBothSectors) {
  for (const Sector sector : {Sector::x_major, Sector::y_major})
    EXPECT_LT(worst_error(sector, 1, true), 1e-3) << static_cast<int>(sector);
}

TEST(RaySamples, MeetThePatternWithFewerTaps) {
  for (const Sector sector : {Sector::x_major, Sector::y_major})
    EXPECT_LT(worst_error(sector, 1, false), 4e-3) << static_cast<int>(sector);
}

TEST(RaySamples, AveragesAreOfThePatternAlongTheRays) {
  for (const Sector sector : {Sector::x_major, Sector::y_major})
    for (const int decimation : {2, 3, 5})
      EXPECT_LT(worst_error(sector, decimation, true), 1e-3) << decimation;
}

TEST(DecimationFilter, WeightsSumToOneAndAreTheSameEitherWay) {
  for (const int decimation : {1, 2, 3, 10}) {
    const DecimationFilter filter(decimation);
    double sum = 0;
    for (int s = -filter.reach(); s <= filter.reach(); ++s) {
      sum += filter.weight(s);
      EXPECT_EQ(filter.weight(s), filter.weight(-s));
    }
    EXPECT_NEAR(sum, 1, 1e-14);  // In double.
  }
}

TEST(DecimationFilter, ItsResponseIsWhatItLeavesOfACosine) {
  for (const int decimation : {1, 2, 7})
    for (const double cycles : {0.0, 0.02, 0.1, 0.37, 0.5}) {
      const DecimationFilter filter(decimation);
      double sum = 0;
      for (int s = -filter.reach(); s <= filter.reach(); ++s)
        sum += filter.weight(s) * std::cos(2 * std::numbers::pi * cycles * s);
      EXPECT_NEAR(filter.response(cycles), sum, 1e-12) << cycles;  // A recurrence, in double.
    }
}

TEST(DecimationFilter, TakesWhatRowsCannotHoldAndLeavesTheRest) {
  for (const int decimation : {2, 7}) {
    const DecimationFilter filter(decimation);
    EXPECT_GT(filter.response(0.25 / decimation), 0.7);
    EXPECT_LT(std::abs(filter.response(0.9 / decimation)), 0.1);
  }
}

}  // namespace
}  // namespace glare
