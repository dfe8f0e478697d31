// The loops over complex values: what else `vector_loops.h` has is in vector_loops_test.cpp.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <complex>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include "glare/base/aligned_buffer.h"
#include "glare/integration/vector_transform.h"

namespace glare {
namespace {

/// Sums of so many products of values between -1 and 1, in single precision: a rounding each.
double rounding(std::size_t products) { return 6e-8 * static_cast<double>(products + 2); }

std::vector<float> random_values(std::size_t count) {
  static std::mt19937 random(1);
  std::uniform_real_distribution<float> value(-1, 1);
  std::vector<float> values(count);
  for (float& v : values) v = value(random);
  return values;
}

/// Each test is run with every instruction set that was compiled and that the machine has, down to
/// the one that any machine has. All meet the same plain loops in double, and so one another.
class ComplexLoops : public testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { choose(GetParam()); }
  void TearDown() override { choose(0); }

 private:
  static void choose(std::int64_t targets) {  // 0: all of them.
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

INSTANTIATE_TEST_SUITE_P(EveryTarget, ComplexLoops,
                         testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& test) { return hwy::TargetName(test.param); });

/// The transform of a pass by its definition, in double.
TEST_P(ComplexLoops, TransformPassAndMultiplyRows) {
  using Complex = std::complex<double>;
  constexpr int kSignals = kRaysPerBlock / 2, kRuns = 3, kGroups = 2;
  for (int test = 0; test < 8; ++test) {
    const int radix = 2 + test / 2, rows = radix * kRuns * kGroups;
    const bool backward = test % 2 == 1;
    AlignedBuffer<std::complex<float>> in(rows * kSignals), out(rows * kSignals);
    const auto parts = random_values(2 * rows * kSignals), turn_parts = random_values(2 * rows);
    std::vector<std::complex<float>> turns;
    for (int i = 0; i < rows; ++i) turns.emplace_back(turn_parts[2 * i], turn_parts[2 * i + 1]);
    const auto x = in.values(), y = out.values();
    for (int i = 0; i < rows * kSignals; ++i) x[i] = {parts[2 * i], parts[2 * i + 1]};
    transform_pass({radix, kRuns, kGroups, backward, turns.data()}, x.data(), kSignals, y.data());
    for (int i = 0; i < rows * kSignals; ++i) {
      const int s = i % kSignals, row = i / kSignals, q = row % kGroups;
      const int j = row / kGroups % radix, p = row / (kGroups * radix);
      Complex sum = 0;
      for (int k = 0; k < radix; ++k)
        sum += Complex(x[((k * kRuns + p) * kGroups + q) * kSignals + s]) *
               std::polar(1.0, (backward ? 2 : -2) * std::numbers::pi * j * k / radix);
      if (j > 0) sum *= Complex(turns[p * (radix - 1) + j - 1]);
      ASSERT_LT(std::abs(Complex(y[i]) - sum), 4 * rounding(radix)) << radix << " " << i;
    }
    multiply_rows(turns, x.data(), y.data());
    for (int i = 0; i < rows * kSignals; ++i)
      ASSERT_LT(std::abs(Complex(y[i]) - Complex(x[i]) * Complex(turns[i / kSignals])),
                rounding(4));
  }
}

}  // namespace
}  // namespace glare
