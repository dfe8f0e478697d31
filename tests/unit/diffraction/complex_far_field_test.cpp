#include "glare/diffraction/complex_far_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace glare {
namespace {

using Complex = std::complex<float>;

constexpr int kWidth = 7, kHeight = 5;
constexpr double kPixel_mm = 0.1;

/// No symmetry at all.
Complex amplitude(int x, int y) {
  return std::polar(0.2f + 0.1f * static_cast<float>(x),
                    0.7f * static_cast<float>(x * y) + 0.3f * static_cast<float>(y * y));
}

ComplexOpenPart part() {
  double sum = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) sum += std::norm(amplitude(x, y));
  return {kWidth, kHeight, kPixel_mm, sum * kPixel_mm * kPixel_mm,
          [](int y, std::span<Complex> row) {
            for (int x = 0; x < kWidth; ++x) row[static_cast<std::size_t>(x)] = amplitude(x, y);
          }};
}

double direct_mm2(double fx_per_mm, double fy_per_mm) {
  std::complex<double> sum = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      sum += std::complex<double>(amplitude(x, y)) *
             std::polar(1.0, -2 * std::numbers::pi * kPixel_mm * (x * fx_per_mm + y * fy_per_mm));
  return std::norm(sum * kPixel_mm * kPixel_mm) / part().energy_area_mm2;
}

TEST(ComplexFarField, PartsAreThoseOfTheDirectSum) {
  FarFieldRequest request;
  request.max_frequency_x_per_mm = 7;  // Beyond 1 / (2 pixel), where frequencies repeat.
  request.max_frequency_y_per_mm = 3;
  request.overlap_frequency_x_per_mm = 0.5;
  const FarFieldParts parts = complex_far_field(part(), request);
  EXPECT_TRUE(parts.odd.odd);
  EXPECT_FALSE(parts.even.odd);
  const double largest_mm2 = part().energy_area_mm2;
  const Image<float>& even = parts.even.intensity_mm2;
  for (int r = 0; r < even.height(); ++r)
    for (int c = 0; c < even.width(); ++c) {
      const double fx = (r + parts.even.first_kx) * parts.even.bin_x_per_mm;
      const double fy = (c + parts.even.first_ky) * parts.even.bin_y_per_mm;
      const double here = direct_mm2(fx, fy), opposite = direct_mm2(-fx, -fy);
      const double rounding = 1e-5 * largest_mm2;  // Single precision.
      ASSERT_NEAR(even(c, r), (here + opposite) / 2, rounding) << r << " " << c;
      ASSERT_NEAR(parts.odd.intensity_mm2(c, r), (here - opposite) / 2, rounding) << r << " " << c;
    }
}

TEST(ComplexFarField, TakesTheBytesItSays) {
  FarFieldRequest request;
  request.max_frequency_x_per_mm = request.max_frequency_y_per_mm = 4;
  request.threads = 1;
  const FarFieldParts parts = complex_far_field(part(), request);
  const std::size_t held = 2 * parts.even.intensity_mm2.values().size() * sizeof(float);
  EXPECT_GT(complex_far_field_bytes(kWidth, kHeight, kPixel_mm, request), held);
}

}  // namespace
}  // namespace glare
