#include "glare/integration/point_interpolation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace glare {
namespace {

constexpr WindowedSinc kKernels[] = {{12, 8.5}, {12, 6}, {8, 6}};

TEST(PointInterpolation, WeightsSumToOne) {
  for (const WindowedSinc& kernel : kKernels) {
    const PointInterpolation interpolation(kernel);
    EXPECT_EQ(interpolation.taps(), kernel.taps);
    for (double fraction = 0; fraction < 1; fraction += 0.00137) {
      const auto weights = interpolation.weights_at(fraction);
      EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-14);  // In double.
    }
  }
}

TEST(PointInterpolation, WeightsAreTheKernelsButForTheTable) {
  // A line over 1/1024 of a sample errs by an eighth of its square times the curvature: that of a
  // sinc is pi^2 / 3 at most, to which the window adds some.
  constexpr double kTable = 1.0 / (1024 * 1024) / 8 * 5;
  for (const WindowedSinc& kernel : kKernels) {
    const PointInterpolation interpolation(kernel);
    for (double fraction = 0; fraction < 1; fraction += 0.00137) {
      const auto found = interpolation.weights_at(fraction);
      const auto expected = interpolation_weights(kernel, fraction);
      for (int j = 0; j < WindowedSinc::kMostTaps; ++j)
        EXPECT_NEAR(found[j], expected[j], kTable) << fraction << " " << j;
    }
  }
}

TEST(PointInterpolation, MeetsACosine) {
  // Kaiser's window of beta 8.5 ripples by 1e-4, its pass band ends at a quarter of a cycle a
  // sample or a little beyond; of beta 6, by 1e-3.
  struct Case {
    WindowedSinc kernel;
    double cycles, error;
  };
  for (const Case& c : {Case{{12, 8.5}, 1 / 8.0, 2e-4},
                        {{12, 8.5}, 1 / 4.0, 4e-4},
                        {{12, 6}, 1 / 8.0, 3e-3},
                        {{12, 6}, 1 / 4.0, 3e-3}}) {
    const PointInterpolation interpolation(c.kernel);
    const auto wave = [&](double s) { return std::cos(2 * std::numbers::pi * c.cycles * s); };
    for (double place = 20; place < 60; place += 0.0371) {
      const double whole = std::floor(place);
      const auto weights = interpolation.weights_at(place - whole);
      double sum = 0;
      for (int j = 0; j < c.kernel.taps; ++j)
        sum += weights[j] * wave(whole - c.kernel.taps / 2 + 1 + j);
      ASSERT_NEAR(sum, wave(place), c.error) << c.cycles << " " << place;
    }
  }
}

}  // namespace
}  // namespace glare
