#include "glare/integration/vector_loops.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/every_target.h"

namespace glare {
namespace {

constexpr float kUntouched = 1234.5f;

using test::random_values;
using test::rounding;

class VectorLoops : public test::EveryTarget {};
INSTANTIATE_TEST_SUITE_P(EveryTarget, VectorLoops, test::every_target(), test::target_name);

TEST_P(VectorLoops, UseTheTargetAskedFor) {
  EXPECT_EQ(std::string(vector_target_name()), hwy::TargetName(GetParam()));
}

/// The value at one place, by the table's entries, linear between them.
template <int kTaps>
double value_at(const float* row, double place, const InterpolationTable<kTaps>& table) {
  const double whole = std::floor(place), steps = (place - whole) * table.kSteps;
  const auto& entry = table.entries()[static_cast<int>(steps)];
  const double rest = steps - std::floor(steps);
  double sum = 0;
  for (int j = 0; j < kTaps; ++j)
    sum += (entry.weights[j] + rest * entry.change[j]) *
           row[static_cast<int>(whole) - kTaps / 2 + 1 + j];
  return sum;
}

/// Places are rounded to 2e-6 of a sample, a group's last being up to 23 samples from its first;
/// between samples from -1 to 1 the slope is 5 at most.
constexpr double kPlaces = 1e-5;

template <int kTaps>
void expect_interpolated(std::size_t rows) {
  const InterpolationTable<kTaps> table(7);
  const std::vector<float> line = random_values(600);
  const float* const row = line.data() + 300;
  for (const double step : {0.0, 0.013, 0.77, 1.0, 3.1})
    for (const double first : {-40.3, 0.0, 12.999999, 100.5})
      for (int count = 1; count < 36; ++count) {
        std::vector<float> found(static_cast<std::size_t>(count) + 1, kUntouched), b = found,
                                                                                   c = found;
        const EvenPlaces places{first, step, count};
        if constexpr (kTaps == 12) {
          if (rows == 3)
            interpolate({row, row + 7, row - 50}, places, table,
                        {found.data(), b.data(), c.data()});
          else
            interpolate(row, places, table, found.data());
        } else {
          interpolate(row, places, table, found.data());
        }
        for (int i = 0; i < count; ++i) {
          ASSERT_NEAR(found[i], value_at(row, first + i * step, table), kPlaces)
              << count << " " << i;
          if (rows < 3) continue;
          ASSERT_NEAR(b[i], value_at(row + 7, first + i * step, table), kPlaces);
          ASSERT_NEAR(c[i], value_at(row - 50, first + i * step, table), kPlaces);
        }
        ASSERT_EQ(found.back(), kUntouched);
      }
}

TEST_P(VectorLoops, InterpolateWithEightTaps) { expect_interpolated<8>(1); }
TEST_P(VectorLoops, InterpolateWithTwelveTaps) { expect_interpolated<12>(1); }
TEST_P(VectorLoops, InterpolateInThreeRows) { expect_interpolated<12>(3); }

TEST_P(VectorLoops, SumWeightedRows) {
  for (const std::size_t terms : {1, 2, 7, 12})
    for (int count = 0; count < 70; ++count) {
      constexpr std::size_t kStride = 71;
      const auto weights = random_values(terms), rows = random_values(terms * kStride);
      std::vector<float> found(static_cast<std::size_t>(count) + 1, kUntouched);
      sum_weighted_rows(weights, rows.data(), kStride, count, found.data());
      for (int i = 0; i < count; ++i) {
        double sum = 0;
        for (std::size_t t = 0; t < terms; ++t) sum += double{weights[t]} * rows[t * kStride + i];
        ASSERT_NEAR(found[i], sum, rounding(terms)) << terms << " " << count;
      }
      ASSERT_EQ(found[count], kUntouched);
    }
}

TEST_P(VectorLoops, SumWeightedRowsOfBlocks) {
  for (const std::size_t terms : {1, 2, 5, 12})
    for (const int blocks : {1, 2, 5}) {
      const std::size_t apart = 15 * kRaysPerBlock;
      const auto weights = random_values(terms), rows = random_values(apart * blocks);
      std::vector<float> found(static_cast<std::size_t>(blocks) * kRaysPerBlock + 1, kUntouched);
      sum_weighted_block_rows(weights, rows.data(), apart, blocks, found.data());
      for (int i = 0; i < blocks * kRaysPerBlock; ++i) {
        double sum = 0;
        for (std::size_t t = 0; t < terms; ++t)
          sum += double{weights[t]} *
                 rows[i / kRaysPerBlock * apart + t * kRaysPerBlock + i % kRaysPerBlock];
        ASSERT_NEAR(found[i], sum, rounding(terms)) << terms << " " << blocks;
      }
      ASSERT_EQ(found.back(), kUntouched);
    }
}

TEST_P(VectorLoops, SumWeightedNeighbours) {
  for (const std::size_t terms : {1, 5, 8, 9, 21, 33})
    for (const int step : {1, 2, 3, 8})
      for (int count = 0; count < 40; ++count) {
        const auto weights = random_values(terms), line = random_values(40 * 8 + terms);
        std::vector<float> found(static_cast<std::size_t>(count) + 1, kUntouched);
        sum_weighted_neighbours(weights, line.data(), step, count, found.data());
        for (int i = 0; i < count; ++i) {
          double sum = 0;
          for (std::size_t t = 0; t < terms; ++t) sum += double{weights[t]} * line[i * step + t];
          ASSERT_NEAR(found[i], sum, rounding(terms)) << terms << " " << step << " " << count;
        }
        ASSERT_EQ(found[count], kUntouched);
      }
}

TEST_P(VectorLoops, AddWeighted) {
  for (int count = 0; count < 40; ++count) {
    const auto line = random_values(40), before = random_values(41);
    auto target = before;
    add_weighted(0.7f, line.data(), count, target.data());
    for (int i = 0; i < count; ++i)
      ASSERT_NEAR(target[i], before[i] + double{0.7f} * line[i], rounding(1));
    ASSERT_EQ(target[count], before[count]);
  }
}

TEST_P(VectorLoops, Transpose) {
  const auto values = random_values(40 * 40);
  for (int rows = 0; rows < 14; ++rows)
    for (int columns = 0; columns < 14; ++columns)
      for (const int step : {1, -1})
        for (const std::ptrdiff_t row_stride : {37, -31}) {
          const float* const source = values.data() + 800;
          std::vector<float> target(14 * 15, kUntouched);
          transpose(source, row_stride, step, rows, columns, target.data(), 15);
          for (int c = 0; c < 14; ++c)
            for (int r = 0; r < 15; ++r)
              ASSERT_EQ(target[c * 15 + r],
                        r < rows && c < columns ? source[r * row_stride + c * step] : kUntouched)
                  << rows << " " << columns << " " << step;
        }
}

}  // namespace
}  // namespace glare
