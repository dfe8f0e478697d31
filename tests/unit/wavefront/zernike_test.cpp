#include "glare/wavefront/zernike.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace glare {
namespace {

double value(int j, double x, double y) {
  const ZernikeCoefficient one[] = {{j, 1}};
  return ZernikeSum(one)(x, y);
}

TEST(Zernike, IndicesAreOsaAnsi) {
  EXPECT_EQ(zernike_index(0), (ZernikeIndex{0, 0}));
  EXPECT_EQ(zernike_index(3), (ZernikeIndex{2, -2}));
  EXPECT_EQ(zernike_index(4), (ZernikeIndex{2, 0}));
  EXPECT_EQ(zernike_index(7), (ZernikeIndex{3, -1}));
  EXPECT_EQ(zernike_index(12), (ZernikeIndex{4, 0}));
  for (int j = 0; j <= highest_zernike_j(); ++j) EXPECT_EQ(zernike_j(zernike_index(j)), j);
  EXPECT_EQ(highest_zernike_j(), 230);
  EXPECT_FALSE(is_valid({2, 1}));
  EXPECT_FALSE(is_valid({2, -4}));
  EXPECT_FALSE(is_valid({21, 1}));
}

TEST(Zernike, NamedTermsAreTheStandardsFormulas) {
  const double x = 0.3, y = -0.55, square = x * x + y * y;
  EXPECT_NEAR(value(1, x, y), 2 * y, 1e-14);  // Tilt: sin.
  EXPECT_NEAR(value(2, x, y), 2 * x, 1e-14);
  EXPECT_NEAR(value(3, x, y), 2 * std::sqrt(6) * x * y, 1e-14);  // Astigmatism at 45 degrees.
  EXPECT_NEAR(value(4, x, y), std::sqrt(3) * (2 * square - 1), 1e-14);
  EXPECT_NEAR(value(5, x, y), std::sqrt(6) * (x * x - y * y), 1e-14);
  EXPECT_NEAR(value(7, x, y), std::sqrt(8) * (3 * square - 2) * y, 1e-14);  // Vertical coma.
  EXPECT_NEAR(value(9, x, y), std::sqrt(8) * (x * x * x - 3 * x * y * y), 1e-14);
  EXPECT_NEAR(value(12, x, y), std::sqrt(5) * (6 * square * square - 6 * square + 1), 1e-14);
}

/// Means over the disc by the midpoint rule in r^2, fine enough for 1e-3, and evenly spaced angles,
/// which are exact.
TEST(Zernike, PolynomialsAreOrthonormal) {
  constexpr int kTerms = 28, kRadii = 200, kAngles = 32;
  double sums[kTerms][kTerms] = {};
  for (int i = 0; i < kRadii; ++i)
    for (int k = 0; k < kAngles; ++k) {
      const double r = std::sqrt((i + 0.5) / kRadii), a = 2 * std::numbers::pi * k / kAngles;
      double values[kTerms];
      for (int j = 0; j < kTerms; ++j) values[j] = value(j, r * std::cos(a), r * std::sin(a));
      for (int j = 0; j < kTerms; ++j)
        for (int l = 0; l < kTerms; ++l) sums[j][l] += values[j] * values[l] / (kRadii * kAngles);
    }
  for (int j = 0; j < kTerms; ++j)
    for (int l = 0; l < kTerms; ++l) EXPECT_NEAR(sums[j][l], j == l ? 1 : 0, 2e-3) << j << " " << l;
}

TEST(Zernike, HighestOrderIsStillItselfAtTheRim) {
  // |Z| at r = 1 on the cosine's crest is the normalisation alone, since R(1) = 1.
  EXPECT_NEAR(value(zernike_j({20, 0}), 1, 0), std::sqrt(21), 1e-6);
  EXPECT_NEAR(value(zernike_j({20, 10}), 1, 0), std::sqrt(42), 1e-6);
}

}  // namespace
}  // namespace glare
