// The reference for large pictures, held against the slow one.
#include "support/exact_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>

#include "support/apertures.h"
#include "support/gridded_intensity.h"
#include "support/lamps.h"

namespace glare {
namespace {

constexpr double kMmPerNm = 1e-6;

using exact::Pixel;
using exact::PixelRequest;

std::vector<int> all_rows(int height) {
  std::vector<int> rows(height);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

std::vector<Pixel> all_pixels(int width, int height) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels.push_back({x, y});
  return pixels;
}

// The largest relative difference from `exact::xyz` in any pixel and channel.
double error_against_all_sums(const Aperture& aperture, int width, int height, double pitch_rad) {
  const exact::Observer observer = test::tables_of(color_matching_functions("cie1931-2deg"));
  const std::vector<exact::SpectralTable> lamps = {test::table_of(test::lamp_with_narrow_lines())};
  const double fov_deg = pitch_rad * width * 180 / std::numbers::pi;
  const auto expected = exact::xyz(
      aperture, {width, height, fov_deg, all_rows(height), 400, 700, 4, 0}, observer, lamps);
  const PixelRequest request{width, height, pitch_rad, all_pixels(width, height), 400, 700};
  const auto found = exact::xyz_at(aperture, request, observer, lamps);
  double error = 0;
  for (std::size_t i = 0; i < request.pixels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      error = std::max(error, std::abs(found.xyz[0][i][c] / expected[0](request.pixels[i].x,
                                                                        request.pixels[i].y)[c] -
                                       1));
  return error;
}

// Both are converged in wavelength to about 1e-8 here: twice as many change that much.
constexpr double kTolerance = 1e-7;

TEST(ExactPixels, AreThoseOfTheSumOverAllSamples) {
  const Aperture aperture = test::lopsided({33, 22, 2});
  const double bin_rad = 560 * kMmPerNm / (4 * 2);
  EXPECT_LT(error_against_all_sums(aperture, 40, 30, bin_rad), kTolerance);
  EXPECT_LT(error_against_all_sums(aperture, 31, 40, 0.03 * bin_rad), kTolerance);
  EXPECT_LT(error_against_all_sums(aperture, 24, 18, 7.3 * bin_rad), kTolerance);
}

TEST(ExactPixels, AreRightBeyondTheReachWhereThePatternRepeats) {
  const Aperture aperture = test::lashed_pupil({24, 24, 2}, 1.9);
  const double period_rad = 560 * kMmPerNm / aperture.pixel_mm();
  EXPECT_LT(error_against_all_sums(aperture, 48, 48, 3 * period_rad / 48), kTolerance);
}

TEST(ExactPixels, KeepTheTailOfALargeAperture) {
  // As far out as the samples reach, where the pattern is down to 1e-11 of its peak. Rounding goes
  // with the peak.
  const Aperture aperture = test::lashed_pupil({512, 512, 5}, 4.9);
  const double pixel_per_mm = 0.3 / 5;
  const exact::GriddedIntensity intensity(aperture, pixel_per_mm, 0);
  exact::GriddedIntensity::Weights weights;
  const double lambda_mm = 500 * kMmPerNm;
  // A pixel so small that its mean is the value in its middle.
  const double half = 1e-5 * pixel_per_mm;
  const double peak = intensity.mean({-half, half, -half, half}, weights);
  for (const auto& [fx, fy] : {std::pair{51.1, 3.3}, {-20.7, 48.9}, {0.4, -51.0}, {35.2, 37.7}}) {
    const double expected =
        exact::psf_point(aperture, fx * lambda_mm, fy * lambda_mm, 500) * lambda_mm * lambda_mm;
    const double found = intensity.mean({fx - half, fx + half, fy - half, fy + half}, weights);
    EXPECT_NEAR(found, expected, 1e-18 * peak) << fx << ' ' << fy;
  }
}

TEST(ExactPixels, RefuseWhatHasNoAnswer) {
  const exact::Observer observer = test::tables_of(color_matching_functions("cie1931-2deg"));
  const std::vector<exact::SpectralTable> lamps = {{{400, 700}, {1, 1}}};
  const Aperture aperture = test::square({8, 8, 1}, 0.5);
  const auto run = [&](const PixelRequest& request) {
    return exact::xyz_at(aperture, request, observer, lamps);
  };
  EXPECT_THROW(run({4, 4, 1e-5, {{4, 0}}, 400, 700}), std::invalid_argument);
  EXPECT_THROW(run({4, 4, 1e-5, {{0, 0}}, 700, 400}), std::invalid_argument);
  EXPECT_THROW(run({4, 4, 1e-5, {{0, 0}}, 900, 950}), std::invalid_argument);
}

TEST(SpreadPixels, AreDifferentAndInsideAndReachTheBorders) {
  const auto pixels = exact::spread_pixels(300, 200, 1000, 1, 180);
  const std::set<Pixel> different(pixels.begin(), pixels.end());
  EXPECT_EQ(different.size(), pixels.size());
  EXPECT_GT(pixels.size(), 700u);
  int left = 300, bottom = 0;
  for (const Pixel& pixel : pixels) {
    EXPECT_TRUE(pixel.x >= 0 && pixel.x < 300 && pixel.y >= 0 && pixel.y < 200);
    left = std::min(left, pixel.x);
    bottom = std::max(bottom, pixel.y);
  }
  EXPECT_LT(left, 10);
  EXPECT_GT(bottom, 190);
}

}  // namespace
}  // namespace glare
