#include "glare/diffraction/padded_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace glare {
namespace {

using Complex = std::complex<double>;

Complex direct(const std::vector<Complex>& x, int k, int length) {
  Complex sum = 0;
  for (std::int64_t n = 0; n < std::ssize(x); ++n)
    sum += x[n] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(n * k % length) /
                                      static_cast<double>(length));
  return sum;
}

void expect_direct(int samples, int length) {
  const PaddedTransform transform(samples, length);
  ASSERT_GE(transform.input_count(), samples);
  std::vector<Complex> x;
  std::vector<std::complex<float>> input(transform.input_count());
  for (int n = 0; n < samples; ++n) {
    x.emplace_back((n * n * 7 % 13) / 13.0, (n * 5 % 17) / 17.0);
    input[n] = std::complex<float>(x[n]);
  }
  PaddedTransform::Workspace workspace;
  const auto result = transform.execute(input, workspace);
  for (int k = 0; k < length; ++k)
    ASSERT_LT(std::abs(Complex(result[k % 4][k / 4]) - direct(x, k, length)), 2e-6 * (samples + 4))
        << samples << " of " << length << ", k " << k;
}

TEST(PaddedTransform, IsTheSumByItsDefinition) {
  for (const int length : {4, 8, 12, 64, 100, 252})
    for (const int quarters : {1, 2, 3, 4})
      for (const int less : {0, 1, length / 4 - 1})
        expect_direct(std::max(1, quarters * length / 4 - less), length);
}

TEST(PaddedTransform, OneWorkspaceServesSeveral) {
  PaddedTransform::Workspace workspace;
  for (const int length : {64, 32, 128}) {
    const PaddedTransform transform(1, length);
    std::vector<std::complex<float>> input(transform.input_count());
    input[0] = {2, -3};
    const auto result = transform.execute(input, workspace);
    for (int k = 0; k < length; ++k)
      ASSERT_LT(std::abs(result[k % 4][k / 4] - input[0]), 1e-6f) << length;
  }
}

}  // namespace
}  // namespace glare
