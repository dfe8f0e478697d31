// The streaks of a lens's iris: each straight edge throws light across itself, to both sides.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "glare/glare.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSize = 401;

/// The template of a diaphragm of 2 mm, in pixels of half lambda / diameter.
Image<float> streaks_of(int blade_count, double roundness = 0) {
  DiaphragmParameters p;
  p.diameter_mm = 2;
  p.blade_count = blade_count;
  p.roundness = roundness;
  const double wavelength_mm = 550e-6;
  return test::luminance_of(draw_diaphragm(p, 0.004), test::line_lamp(550, 30),
                            test::absolute_xyz(kSize, kSize, 0.5 * wavelength_mm / 2));
}

/// Mean luminance times distance^2, from 30 to 100 lambda / diameter, in each degree clockwise from
/// up.
std::vector<double> by_direction(const Image<float>& y) {
  std::vector<double> sum(360), count(360);
  const int c = kSize / 2;
  for (int j = 0; j < kSize; ++j)
    for (int i = 0; i < kSize; ++i) {
      const double r = std::hypot(i - c, j - c);
      if (r < 60 || r > 200) continue;
      const double turn = std::atan2(i - c, c - j) * 180 / kPi;
      const auto bin = static_cast<std::size_t>(std::lround(turn + 360)) % 360;
      sum[bin] += y(i, j) * r * r;
      ++count[bin];
    }
  for (std::size_t bin = 0; bin < 360; ++bin) sum[bin] /= count[bin];
  return sum;
}

/// Directions, in degrees, in which there is more than anywhere within 8 degrees, and three times
/// the median.
std::vector<int> streak_directions(const std::vector<double>& light) {
  std::vector<double> sorted = light;
  std::ranges::sort(sorted);
  std::vector<int> directions;
  for (int a = 0; a < 360; ++a) {
    bool highest = light[a] > 3 * sorted[180];
    for (int d = 1; d <= 8; ++d)
      highest =
          highest && light[a] > light[(a + d) % 360] && light[a] >= light[(a + 360 - d) % 360];
    if (highest) directions.push_back(a);
  }
  return directions;
}

class Streaks : public testing::TestWithParam<int> {};

TEST_P(Streaks, AreNForEvenNAndTwiceNForOddN) {
  const int blade_count = GetParam();
  const auto directions = streak_directions(by_direction(streaks_of(blade_count)));
  const int expected = blade_count % 2 == 0 ? blade_count : 2 * blade_count;
  ASSERT_EQ(directions.size(), static_cast<std::size_t>(expected));
  // A corner points up at rotation 0, so that an edge faces the direction 180 / N from up.
  for (int k = 0; k < expected; ++k) {
    const double across = 180.0 / blade_count + k * 360.0 / expected;
    const double nearest = std::fmod(across, 360.0 / expected);
    const double found = std::fmod(directions[k] + 0.0, 360.0 / expected);
    const double off = std::abs(found - nearest);
    // Bins of a degree.
    EXPECT_LE(std::min(off, 360.0 / expected - off), 1) << directions[k];
  }
}

INSTANTIATE_TEST_SUITE_P(Diaphragm, Streaks, testing::Values(3, 4, 5, 6, 7, 8));

TEST(Diaphragm, ACircleHasNoStreaksAndRoundEdgesWeakerOnes) {
  const auto contrast = [](const std::vector<double>& light) {
    std::vector<double> sorted = light;
    std::ranges::sort(sorted);
    return sorted.back() / sorted[180];
  };
  const double straight = contrast(by_direction(streaks_of(6)));
  const double curved = contrast(by_direction(streaks_of(6, 0.5)));
  EXPECT_GT(straight, 20);
  EXPECT_LT(curved, straight / 4);
  // A few per cent: each degree holds a few rings only.
  EXPECT_LT(contrast(by_direction(streaks_of(6, 1))), 1.2);
}

}  // namespace
}  // namespace glare
