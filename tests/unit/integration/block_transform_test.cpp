#include "glare/integration/block_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace glare {
namespace {

using Complex = std::complex<double>;
constexpr int kSignals = BlockTransform::kSignals;

/// Of values around 1, sums of `length` terms are about its root, and every pass rounds a few
/// times; the worst of some thousand sums is several times worse than most.
double rounding(int length) { return 2e-6 * std::sqrt(length); }

/// Products of 2, 3, 4 and 5, each alone, twice and with the others.
const std::vector<int> kLengths = {2,  3,  4,  5,  6,  8,  9,  10, 12,  15,  16,
                                   18, 20, 24, 25, 27, 30, 32, 60, 100, 150, 360};

/// Rows `stride` apart with values between -1 and 1, and no number between the rows.
std::span<std::complex<float>> random_rows(int length, std::size_t stride,
                                           BlockTransform::Buffer& buffer) {
  std::mt19937 random(static_cast<unsigned>(length));
  std::uniform_real_distribution<float> value(-1, 1);
  const auto rows = buffer.values(static_cast<std::size_t>(length) * stride);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = std::numeric_limits<float>::quiet_NaN();
    if (i % stride < kSignals) rows[i] = {value(random), value(random)};
  }
  return rows;
}

/// The definition, for one frequency of one signal.
Complex direct(std::span<const std::complex<float>> rows, std::size_t stride, int length,
               int signal, int k, int sign) {
  Complex sum = 0;
  for (int n = 0; n < length; ++n)
    sum += Complex(rows[static_cast<std::size_t>(n) * stride + static_cast<std::size_t>(signal)]) *
           std::polar(1.0, sign * 2 * std::numbers::pi * (n * k % length) / length);
  return sum;
}

double worst_error(int length, std::size_t stride, int sign) {
  const BlockTransform transform(length);
  BlockTransform::Buffer input, a, b;
  const auto rows = random_rows(length, stride, input);
  const auto found = sign < 0 ? transform.forward(rows.data(), stride, a, b)
                              : transform.backward(rows.data(), stride, a, b);
  EXPECT_EQ(found.size(), static_cast<std::size_t>(length) * kSignals);
  double worst = 0;
  for (int k = 0; k < length; ++k)
    for (int s = 0; s < kSignals; ++s) {
      const double error = std::abs(Complex(found[static_cast<std::size_t>(k * kSignals + s)]) -
                                    direct(rows, stride, length, s, k, sign));
      if (!(error <= worst)) worst = error;  // No number counts too.
    }
  return worst;
}

TEST(BlockTransform, ForwardIsTheDefinition) {
  for (const int length : kLengths)
    EXPECT_LT(worst_error(length, kSignals, -1), rounding(length)) << length;
}

TEST(BlockTransform, BackwardIsTheDefinition) {
  for (const int length : kLengths)
    EXPECT_LT(worst_error(length, kSignals, 1), rounding(length)) << length;
}

TEST(BlockTransform, TakesRowsThatLieApart) {
  for (const int length : kLengths)
    for (const std::size_t stride : {std::size_t{2} * kSignals, std::size_t{5} * kSignals})
      EXPECT_LT(worst_error(length, stride, -1), rounding(length)) << length << " " << stride;
}

TEST(BlockTransform, ForwardAndBackwardGiveTheLengthTimesTheInput) {
  for (const int length : kLengths) {
    const BlockTransform transform(length);
    BlockTransform::Buffer input, a, b, c, d;
    const auto rows = random_rows(length, kSignals, input);
    const auto there = transform.forward(rows.data(), kSignals, a, b);
    const auto back = transform.backward(there.data(), kSignals, c, d);
    for (std::size_t i = 0; i < rows.size(); ++i)
      ASSERT_LT(std::abs(back[i] / static_cast<float>(length) - rows[i]), 2e-6)  // As `rounding`.
          << length << " " << i;
  }
}

TEST(BlockTransform, KeepsItsInput) {
  for (const int length : {6, 20, 150}) {
    const BlockTransform transform(length);
    BlockTransform::Buffer input, a, b;
    const auto rows = random_rows(length, kSignals, input);
    const std::vector<std::complex<float>> before(rows.begin(), rows.end());
    transform.forward(rows.data(), kSignals, a, b);
    EXPECT_TRUE(std::ranges::equal(rows, before)) << length;
  }
}

TEST(BlockTransform, ItsLengthIsTheSmallestEvenOneThatSuffices) {
  EXPECT_EQ(BlockTransform(360).length(), 360);
  struct Case {
    int minimum, length;
  };
  for (const Case c : {Case{1, 2},
                       {2, 2},
                       {3, 4},
                       {7, 8},
                       {13, 16},
                       {25, 30},
                       {101, 108},
                       {243, 250},
                       {1009, 1024},
                       {4321, 4374}})
    EXPECT_EQ(BlockTransform::length_for(c.minimum), c.length) << c.minimum;
}

}  // namespace
}  // namespace glare
