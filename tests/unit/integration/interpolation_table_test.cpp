#include "glare/integration/interpolation_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace glare {
namespace {

/// Calls check(weights, fraction) with the table's weights at many places.
template <int kTaps, typename Check>
void at_many_places(const InterpolationTable<kTaps>& table, const Check& check) {
  constexpr int kSteps = InterpolationTable<kTaps>::kSteps;
  for (double fraction = 0; fraction < 1; fraction += 0.00071) {
    const int step = static_cast<int>(fraction * kSteps);
    const auto rest = fraction * kSteps - step;
    const auto& entry = table.entries()[step];
    std::array<double, kTaps> weights;
    for (int j = 0; j < kTaps; ++j) weights[j] = entry.weights[j] + rest * entry.change[j];
    check(weights, fraction);
  }
}

template <int kTaps>
void expect_kernel(double kaiser_beta) {
  const InterpolationTable<kTaps> table(kaiser_beta);
  at_many_places(table, [&](const auto& weights, double fraction) {
    const auto expected = interpolation_weights({kTaps, kaiser_beta}, fraction);
    double sum = 0;
    for (int j = 0; j < kTaps; ++j) {
      EXPECT_NEAR(weights[j], expected[j], 1e-5) << fraction;  // What the table states.
      sum += weights[j];
    }
    EXPECT_NEAR(sum, 1, 3e-7);  // A dozen single-precision weights below 1.
  });
}

TEST(InterpolationTable, HoldsTheKernelOfEightTaps) {
  expect_kernel<8>(6.5);
  expect_kernel<8>(4);
}

TEST(InterpolationTable, HoldsTheKernelOfTwelveTaps) {
  expect_kernel<12>(8.5);
  expect_kernel<12>(10.5);
}

TEST(InterpolationTable, StepsMeet) {
  const InterpolationTable<12> table(8.5);
  for (int i = 0; i < table.kSteps; ++i)
    for (int j = 0; j < table.kTaps; ++j)
      ASSERT_NEAR(table.entries()[i].weights[j] + table.entries()[i].change[j],
                  table.entries()[i + 1].weights[j], 1.2e-7);  // One rounding of each.
}

TEST(InterpolationTable, EndsAtTheNextSample) {
  const InterpolationTable<8> table(6.5);
  const auto& last = table.entries()[table.kSteps];
  for (int j = 0; j < 8; ++j) {
    EXPECT_NEAR(last.weights[j], j == 4 ? 1 : 0, 1e-7);  // In single precision.
    EXPECT_EQ(last.change[j], 0);
  }
}

TEST(InterpolationTable, EntriesAreAlignedForVectors) {
  const InterpolationTable<12> table(8.5);
  for (const int i : {0, 1, 77}) {
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(table.entries()[i].weights.data()) % 32, 0u);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(table.entries()[i].change.data()) % 32, 0u);
  }
}

}  // namespace
}  // namespace glare
