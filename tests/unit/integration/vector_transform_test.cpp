// The loops over complex values: what else `vector_loops.h` has is in vector_loops_test.cpp.
#include <gtest/gtest.h>

#include <complex>
#include <cstdint>
#include <numbers>
#include <vector>

#include "glare/base/aligned_buffer.h"
#include "glare/integration/vector_transform.h"
#include "support/every_target.h"

namespace glare {
namespace {

using test::random_values;
using test::rounding;

class ComplexLoops : public test::EveryTarget {};
INSTANTIATE_TEST_SUITE_P(EveryTarget, ComplexLoops, test::every_target(), test::target_name);

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
