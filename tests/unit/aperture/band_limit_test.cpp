#include "glare/aperture/band_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace glare {
namespace {

constexpr int kFine = BandLimit::kFineSamples;

/// What the filter makes of a wave of `f` cycles per pixel that was averaged over fine samples.
double response(double f) {
  const std::vector<double> weights = band_limiting_weights();
  const double f_fine = f / kFine, middle = 0.5 * static_cast<double>(weights.size() - 1);
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k)
    sum += weights[k] * std::cos(2 * std::numbers::pi * f_fine * (static_cast<double>(k) - middle));
  const double x = std::numbers::pi * f_fine;
  return x == 0 ? sum : sum * std::sin(x) / x;
}

TEST(BandLimit, PassesWhatTheFieldNeeds) {
  for (double f = 0; f <= BandLimit::kPassed; f += 0.001)
    EXPECT_NEAR(response(f), 1, BandLimit::kRipple) << f;
}

TEST(BandLimit, StopsWhatWouldFoldOntoIt) {
  for (double f = BandLimit::kStopped; f <= kFine / 2.0; f += 0.001)
    EXPECT_NEAR(response(f), 0, BandLimit::kRipple) << f;
}

TEST(BandLimit, WeightsAreSymmetricAndOfSumOne) {
  const std::vector<double> weights = band_limiting_weights();
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    EXPECT_NEAR(weights[k], weights[weights.size() - 1 - k], 1e-15);  // rounding
    sum += weights[k];
  }
  EXPECT_NEAR(sum, 1, 1e-14);  // rounding
}

/// A fine picture of a wave along x and y, on an open square in its middle.
double wave(const Grid& grid, int x, int y) {
  const double reach = 0.75 * grid.edge(grid.size);
  const double px = grid.centre(x), py = grid.centre(y);
  if (std::max(std::abs(px), std::abs(py)) > reach) return 0;
  return 0.5 + 0.25 * std::cos(2 * px + 1) + 0.25 * std::sin(3 * py);
}

FineRows waves() {
  return [](const Grid& grid, int y, std::span<float> row) {
    double squares = 0;
    for (int x = 0; x < grid.size; ++x) {
      row[x] = static_cast<float>(wave(grid, x, y));
      squares += row[x] * row[x];
    }
    return FineRow{{0, grid.size}, squares};
  };
}

/// The sum over all fine samples, for one pixel.
double filtered(const Grid& fine, int x, int y) {
  const std::vector<double> weights = band_limiting_weights();
  const int count = static_cast<int>(weights.size()), before = (count - kFine) / 2;
  double sum = 0;
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i) {
      const int fx = kFine * x - before + i, fy = kFine * y - before + j;
      if (std::min(fx, fy) < 0 || std::max(fx, fy) >= fine.size) continue;
      sum += weights[i] * weights[j] * wave(fine, fx, fy);
    }
  return sum;
}

TEST(BandLimit, IsTheWeightedSumOfFineSamples) {
  constexpr int size = 150;  // Two tasks.
  const Aperture picture = band_limited(size, 7, waves, 2, {});
  EXPECT_EQ(picture.width_mm, 7);
  const Grid fine{kFine * size, 7.0 / (kFine * size)};
  for (int y = 0; y < size; y += 7)
    for (int x = 0; x < size; x += 7)
      EXPECT_NEAR(picture.transmittance(x, y), filtered(fine, x, y), 1e-6) << x << ", " << y;
}

TEST(BandLimit, KnowsTheFinePicturesEnergy) {
  constexpr int size = 150;
  const Grid fine{kFine * size, 7.0 / (kFine * size)};
  double sum = 0;
  for (int y = 0; y < fine.size; ++y)
    for (int x = 0; x < fine.size; ++x) sum += std::pow(wave(fine, x, y), 2);
  const double area = sum * fine.pixel * fine.pixel;
  // Samples are single precision.
  EXPECT_NEAR(energy_area_mm2(band_limited(size, 7, waves, 1, {})), area, 1e-6 * area);
}

TEST(BandLimit, IsTheSameForAnyNumberOfThreads) {
  const Aperture one = band_limited(300, 7, waves, 1, {}), two = band_limited(300, 7, waves, 2, {});
  EXPECT_TRUE(std::ranges::equal(one.transmittance.values(), two.transmittance.values()));
  EXPECT_EQ(one.unlimited_energy_area_mm2, two.unlimited_energy_area_mm2);
}

}  // namespace
}  // namespace glare
