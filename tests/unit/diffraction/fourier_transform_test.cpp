#include "glare/diffraction/fourier_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace glare {
namespace {

using Complex = std::complex<double>;

std::vector<Complex> sample(int length) {
  std::vector<Complex> out;
  for (int n = 0; n < length; ++n) out.emplace_back((n * n * 7 % 13) / 13.0, (n * 5 % 17) / 17.0);
  return out;
}

Complex direct(const std::vector<Complex>& x, int k) {
  const auto length = static_cast<std::int64_t>(x.size());
  Complex sum = 0;
  for (std::int64_t n = 0; n < length; ++n)
    sum += x[n] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(n * k % length) /
                                      static_cast<double>(length));
  return sum;
}

TEST(FourierTransform, OfComplexNumbers) {
  for (const int length : {1, 2, 6, 64, 70, 135}) {
    const FourierTransform transform(FourierTransform::Kind::complex_to_complex, length);
    const auto x = sample(length);
    AlignedBuffer<std::complex<float>> input(x.size()), output(x.size());
    for (int n = 0; n < length; ++n) input.values()[n] = std::complex<float>(x[n]);
    transform.execute(input.values(), output.values());
    for (int k = 0; k < length; ++k)
      EXPECT_LT(std::abs(Complex(output.values()[k]) - direct(x, k)), 2e-6 * length) << length;
  }
}

TEST(FourierTransform, OfRealNumbers) {
  for (const int length : {2, 10, 64, 126}) {
    const FourierTransform transform(FourierTransform::Kind::real_to_complex, length);
    auto x = sample(length);
    AlignedBuffer<float> input(x.size());
    AlignedBuffer<std::complex<float>> output(x.size() / 2 + 1);
    for (int n = 0; n < length; ++n) {
      x[n] = x[n].real();
      input.values()[n] = static_cast<float>(x[n].real());
    }
    transform.execute(input, output);
    for (int k = 0; k <= length / 2; ++k)
      EXPECT_LT(std::abs(Complex(output.values()[k]) - direct(x, k)), 2e-6 * length) << length;
  }
}

TEST(FourierTransform, BuffersAreAligned) {
  AlignedBuffer<float> buffer(5);
  EXPECT_EQ(buffer.values().size(), 5u);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(buffer.values().data()) % FourierTransform::kAlignment,
            0u);
}

bool is_fast(int length) {
  for (const int factor : {2, 3, 5, 7})
    while (length % factor == 0) length /= factor;
  return length == 1;
}

TEST(FourierTransform, AFastLengthIsTheNextEvenOneOfSmallFactors) {
  for (int minimum = 1; minimum < 3000; ++minimum) {
    int expected = minimum;
    while (expected % 2 != 0 || !is_fast(expected)) ++expected;
    ASSERT_EQ(fast_transform_length(minimum), expected);
  }
}

}  // namespace
}  // namespace glare
