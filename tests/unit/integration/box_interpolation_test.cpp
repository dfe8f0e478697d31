#include "glare/integration/box_interpolation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace glare {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSinglePrecision = 3e-7;  // A few roundings of weights near 1.

std::vector<BoxWeights> boxes(const std::vector<double>& edges) {
  static const BoxInterpolation interpolation;
  std::vector<BoxWeights> result;
  interpolation.weights_between(edges, result);
  return result;
}

template <typename Function>
double mean_of(const BoxWeights& box, const Function& function) {
  double sum = 0;
  for (std::size_t j = 0; j < box.weights.size(); ++j)
    sum += static_cast<double>(box.weights[j]) * function(box.first + static_cast<int>(j));
  return sum;
}

const std::vector<std::vector<double>> kEdges = {
    {0, 1},           {-0.5, 0.5},      {3.2, 3.21}, {-7.75, 12.125},
    {0.999999, 1.00}, {-1e5, -1e5 + 3}, {0.1, 200.3}};

TEST(BoxInterpolation, WeightsSumToOne) {
  for (const auto& edges : kEdges) {
    // Of a narrow interval, a difference of running integrals that were rounded in double.
    const double rounding = kSinglePrecision + 1e-15 / (edges[1] - edges[0]);
    EXPECT_NEAR(mean_of(boxes(edges)[0], [](int) { return 1; }), 1, rounding) << edges[0];
  }
}

TEST(BoxInterpolation, TakesHalfTheKernelsTapsBeyondEachEdge) {
  const int half = kInterpolatingKernel.taps / 2;
  for (const auto& edges : kEdges) {
    const BoxWeights box = boxes(edges)[0];
    EXPECT_EQ(box.first, static_cast<int>(std::floor(edges[0])) - half + 1);
    EXPECT_EQ(box.first + static_cast<int>(box.weights.size()) - 1,
              static_cast<int>(std::floor(edges[1])) + half);
  }
}

/// Largest error of the mean of cos(2 pi f s + phase) over intervals of that width, over phases
/// and places; the true mean is cos at the middle times sinc(f width).
double error_of_cosine(double f, double width) {
  double worst = 0;
  for (double left = 10; left < 11; left += 0.083)
    for (const double phase : {0.0, kPi / 2}) {
      const double angle = kPi * f * width;
      const double expected = std::cos(2 * kPi * f * (left + width / 2) + phase) *
                              (angle == 0 ? 1 : std::sin(angle) / angle);
      const double found = mean_of(boxes({left, left + width})[0],
                                   [&](int s) { return std::cos(2 * kPi * f * s + phase); });
      worst = std::max(worst, std::abs(found - expected));
    }
  return worst;
}

TEST(BoxInterpolation, MeansOfACosineAreWithinTheWindowsRipple) {
  // Frequencies in cycles per sample; the finest detail of a far field padded 4 times is at 1/4.
  // Kaiser's window of beta 10.5 ripples by 3e-5, and its pass band ends near there.
  for (const double width : {0.01, 0.3, 1.0, 2.5, 7.2}) {
    for (const double f : {0.0, 0.03, 0.1, 1 / 6.0, 0.21})
      EXPECT_LT(error_of_cosine(f, width), 4e-5);
    EXPECT_LT(error_of_cosine(0.25, width), 8e-4);
  }
  // A wide interval averages the ripple, even at the band's edge.
  EXPECT_LT(error_of_cosine(0.25, 20), 2e-4);
}

TEST(BoxInterpolation, NeighboursShareNothingAndLoseNothing) {
  std::vector<double> edges;
  for (double edge = -20; edge < 60; edge += 0.37 + 0.004 * (edge + 20)) edges.push_back(edge);
  const auto all = boxes(edges);
  ASSERT_EQ(all.size(), edges.size() - 1);
  for (int sample = -10; sample < 40; ++sample) {  // Each well inside counts once in all.
    double total = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      total +=
          (edges[i + 1] - edges[i]) * mean_of(all[i], [&](int s) { return s == sample ? 1 : 0; });
    EXPECT_NEAR(total, 1, kSinglePrecision) << sample;
  }
}

TEST(BoxInterpolation, AnIntervalIsTheSumOfItsParts) {
  const auto wave = [](int s) { return std::sin(0.7 * s) + 0.2 * s; };
  const auto parts = boxes({2.3, 4.1, 9.65});
  const double whole = mean_of(boxes({2.3, 9.65})[0], wave);
  EXPECT_NEAR((1.8 * mean_of(parts[0], wave) + 5.55 * mean_of(parts[1], wave)) / 7.35, whole,
              10 * kSinglePrecision);
}

}  // namespace
}  // namespace glare
