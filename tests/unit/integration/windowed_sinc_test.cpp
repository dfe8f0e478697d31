#include "glare/integration/windowed_sinc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace glare {
namespace {

constexpr double kRounding = 1e-14;  // A dozen weights below 1, in double.

constexpr WindowedSinc kKernels[] = {kInterpolatingKernel, kAveragingKernel, {8, 6.5}, {2, 3}};

TEST(WindowedSinc, WeightsSumToOne) {
  for (const WindowedSinc& kernel : kKernels)
    for (double fraction = 0; fraction <= 1; fraction += 1 / 64.0) {
      const auto weights = interpolation_weights(kernel, fraction);
      EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, kRounding);
    }
}

TEST(WindowedSinc, AtASampleTakesThatSampleAlone) {
  for (const WindowedSinc& kernel : kKernels)
    for (const int fraction : {0, 1}) {
      const auto weights = interpolation_weights(kernel, fraction);
      for (int j = 0; j < WindowedSinc::kMostTaps; ++j)
        EXPECT_NEAR(weights[j], j == kernel.taps / 2 - 1 + fraction ? 1 : 0, kRounding) << j;
    }
}

TEST(WindowedSinc, IsTheSameFromEitherSide) {
  for (const WindowedSinc& kernel : kKernels)
    for (const double fraction : {0.01, 0.25, 0.4}) {
      const auto weights = interpolation_weights(kernel, fraction);
      const auto mirrored = interpolation_weights(kernel, 1 - fraction);
      for (int j = 0; j < kernel.taps; ++j)
        EXPECT_NEAR(weights[j], mirrored[kernel.taps - 1 - j], kRounding);
    }
}

TEST(WindowedSinc, LeavesWeightsBeyondItsTapsAtZero) {
  const auto weights = interpolation_weights({8, 6.5}, 0.3);
  EXPECT_TRUE(std::all_of(weights.begin() + 8, weights.end(), [](double w) { return w == 0; }));
  EXPECT_NE(weights[0], 0);
  EXPECT_NE(weights[7], 0);
}

TEST(WindowedSinc, EndsWithItsWindow) {
  for (const WindowedSinc& kernel : kKernels) {
    EXPECT_EQ(windowed_sinc(kernel, kernel.taps / 2 + 0.01), 0);
    EXPECT_EQ(windowed_sinc(kernel, -kernel.taps / 2 - 0.01), 0);
    EXPECT_NE(windowed_sinc(kernel, kernel.taps / 2 - 0.01), 0);
  }
}

TEST(WindowedSinc, ItsCutoffMovesTheNulls) {
  const double middle = windowed_sinc(kInterpolatingKernel, 0);
  for (const double cutoff : {0.5, 0.8, 1.0}) {
    EXPECT_NEAR(windowed_sinc(kInterpolatingKernel, 1 / cutoff, cutoff) / middle, 0, kRounding);
    EXPECT_GT(windowed_sinc(kInterpolatingKernel, 0.9 / cutoff, cutoff) / middle, 0.01);
  }
}

TEST(WindowedSinc, ItsWindowIsKaisers) {
  // Between the nulls, sinc (2 / pi) times the window, I0(beta root(1 - u^2)) / I0(beta).
  const double beta = kAveragingKernel.kaiser_beta, u = 0.5 / 6;
  const double window =
      std::cyl_bessel_i(0.0, beta * std::sqrt(1 - u * u)) / std::cyl_bessel_i(0.0, beta);
  EXPECT_NEAR(windowed_sinc(kAveragingKernel, 0.5) / windowed_sinc(kAveragingKernel, 0),
              2 / std::numbers::pi * window, kRounding);
}

/// The largest error of cos(2 pi f s + phase), over places and phases.
double error_of_cosine(const WindowedSinc& kernel, double f) {
  double worst = 0;
  for (double fraction = 0; fraction <= 1; fraction += 1 / 32.0)
    for (double phase = 0; phase < 6.2; phase += 0.3) {
      const auto weights = interpolation_weights(kernel, fraction);
      double sum = 0;
      for (int j = 0; j < kernel.taps; ++j)
        sum += weights[j] * std::cos(2 * std::numbers::pi * f * j + phase);
      const double place = kernel.taps / 2 - 1 + fraction;
      worst = std::max(worst, std::abs(sum - std::cos(2 * std::numbers::pi * f * place + phase)));
    }
  return worst;
}

TEST(WindowedSinc, MeetsACosineWithinTheErrorThatItStates) {
  // Twice the critical rate: the finest detail is at a quarter of a cycle a sample.
  for (const double share : {0.0, 0.1, 0.3, 0.5, 0.7, 5 / 6.0})
    EXPECT_LT(error_of_cosine(kInterpolatingKernel, 0.25 * share), 4e-5) << share;
  EXPECT_LT(error_of_cosine(kInterpolatingKernel, 0.25), 8e-4);
  // Near the critical rate it can't: the window's main lobe is 2 beta / (2 pi 6) wide.
  EXPECT_GT(error_of_cosine(kInterpolatingKernel, 0.45), 0.1);
}

}  // namespace
}  // namespace glare
