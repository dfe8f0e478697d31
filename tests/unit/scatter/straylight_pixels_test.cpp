#include "glare/scatter/straylight_pixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "glare/base/error.h"

namespace glare {
namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180;
constexpr Straylight kEye{24, 0.5};

/// S alone: pixels without any diffracted light.
XyzImage straylight(const PixelGrid& grid, int threads = 2) {
  XyzImage pixels;
  pixels.fill(Image<float>(grid.width, grid.height));
  add_straylight(kEye, grid, {0.9, 1, 0.4}, threads, {}, pixels);
  return pixels;
}

/// The mean over a pixel's square by many places.
double plain_mean(double x, double y, double side) {
  constexpr int kPlaces = 400;
  double sum = 0;
  for (int j = 0; j < kPlaces; ++j)
    for (int i = 0; i < kPlaces; ++i) {
      const double sine = std::hypot(x + side * ((i + 0.5) / kPlaces - 0.5),
                                     y + side * ((j + 0.5) / kPlaces - 0.5));
      if (sine < 1) sum += straylight_per_steradian(kEye, std::asin(sine) / kRadPerDegree);
    }
  return sum / kPlaces / kPlaces;
}

TEST(StraylightPixels, AreMeansOverTheirSquares) {
  for (const double pitch_deg : {0.001, 0.01, 0.05, 0.3, 2.0}) {
    const PixelGrid grid{16, 9, pitch_deg * kRadPerDegree};
    const XyzImage pixels = straylight(grid);
    for (const auto& [x, y] : {std::pair{8, 4}, {9, 4}, {7, 5}, {12, 1}, {0, 0}})
      EXPECT_NEAR(pixels[1](x, y) / plain_mean((x - 8) * grid.pitch_rad, (y - 4) * grid.pitch_rad,
                                               grid.pitch_rad),
                  1, 1e-4)  // The plain sum's own error, in the widest pixel on the axis.
          << pitch_deg << " degrees, " << x << ", " << y;
  }
}

TEST(StraylightPixels, NinePixelsAverageToOneOfThriceTheSide) {
  // A third of the pitch, since the axis is the centre of a pixel in both.
  for (const double pitch_deg : {0.003, 0.03, 0.6}) {
    const XyzImage coarse = straylight({21, 21, pitch_deg * kRadPerDegree});
    const XyzImage fine = straylight({63, 63, pitch_deg * kRadPerDegree / 3});
    for (int y = 0; y < 21; ++y)
      for (int x = 0; x < 21; ++x) {
        double sum = 0;
        for (int v = 0; v < 3; ++v)
          for (int u = 0; u < 3; ++u) sum += fine[1](3 * x + u, 3 * y + v);
        EXPECT_NEAR(sum / 9 / coarse[1](x, y), 1, 1e-5) << x << ", " << y;
      }
  }
}

TEST(StraylightPixels, HaveTheLampsColorAndAreSymmetric) {
  const XyzImage pixels = straylight({32, 18, 0.02 * kRadPerDegree});
  for (int y = 1; y < 18; ++y)
    for (int x = 1; x < 32; ++x) {
      EXPECT_FLOAT_EQ(pixels[0](x, y), 0.9f * pixels[1](x, y));
      EXPECT_FLOAT_EQ(pixels[2](x, y), 0.4f * pixels[1](x, y));
      EXPECT_EQ(pixels[1](x, y), pixels[1](32 - x, y));
      EXPECT_EQ(pixels[1](x, y), pixels[1](x, 18 - y));
    }
}

TEST(StraylightPixels, TakeTheScatteredShareFromWhatWasThere) {
  const PixelGrid grid{8, 8, 1e-4};
  XyzImage pixels;
  pixels.fill(Image<float>(8, 8, 1e6f));
  const double share = add_straylight(kEye, grid, {0.9, 1, 0.4}, 1, {}, pixels);
  EXPECT_EQ(share, scattered_energy(kEye));
  const XyzImage added = straylight(grid);
  for (std::size_t i = 0; i < 64; ++i)
    EXPECT_NEAR(pixels[2].values()[i], (1 - share) * 1e6 + added[2].values()[i], 0.1);
}

TEST(StraylightPixels, AreTheSameForAnyNumberOfThreadsAndCanBeCancelled) {
  const PixelGrid grid{40, 31, 1e-4};
  const XyzImage one = straylight(grid, 1), two = straylight(grid, 2);
  for (std::size_t i = 0; i < one[1].values().size(); ++i)
    ASSERT_EQ(one[1].values()[i], two[1].values()[i]);
  XyzImage pixels = one;
  EXPECT_THROW(add_straylight(
                   kEye, grid, {1, 1, 1}, 1, [](double) { return false; }, pixels),
               Cancelled);
}

TEST(StraylightPixels, TheEquationsMeanIsStraylightsWhereTheyAreTheSame) {
  const XyzImage pixels = straylight({101, 101, 0.05 * kRadPerDegree});
  for (const int x : {57, 70, 100})  // 0.35 degrees and more.
    EXPECT_NEAR(cie_pixel_mean(kEye, (x - 50) * 0.05 * kRadPerDegree, 0, 0.05 * kRadPerDegree) /
                    pixels[1](x, 50),
                1, 1e-5);
}

}  // namespace
}  // namespace glare
