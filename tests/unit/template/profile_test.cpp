#include "glare/template/profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glare/base/error.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kPitch_deg = 0.01, kPitch_rad = kPitch_deg * kPi / 180;

/// A template of these luminances, grey in Rec.709, 250 per steradian to 1.
template <typename Luminance>
GlareTemplate grey(int width, int height, const Luminance& luminance) {
  GlareTemplate t;
  t.channels.fill(test::picture(width, height, luminance));
  t.pixel_pitch_rad = kPitch_rad;
  t.per_steradian = 250;
  return t;
}

TEST(Profile, OfAConstantIsTheConstantPerSteradian) {
  const auto rings = radial_profile(grey(101, 81, [](int, int) { return 4; }));
  EXPECT_EQ(rings.front().inner_deg, 0);
  EXPECT_DOUBLE_EQ(rings.front().outer_deg, kPitch_deg / 2);
  EXPECT_DOUBLE_EQ(rings.back().outer_deg, 40.5 * kPitch_deg);  // The nearest border.
  for (const ProfileRing& ring : rings)
    EXPECT_NEAR(ring.mean_per_steradian, 1000, 1e-3);  // Single precision.
}

TEST(Profile, RingsFollowOneAnother) {
  const auto rings = radial_profile(grey(201, 201, [](int, int) { return 1; }));
  for (std::size_t i = 1; i < rings.size(); ++i) {
    EXPECT_DOUBLE_EQ(rings[i].inner_deg, rings[i - 1].outer_deg);
    const double width = rings[i].outer_deg - rings[i].inner_deg;
    if (i + 1 < rings.size()) {
      EXPECT_GE(width, kPitch_deg * (1 - 1e-12));  // Rounding.
    }
    EXPECT_LE(rings[i].outer_deg,
              std::max(rings[i].inner_deg + kPitch_deg, rings[i].inner_deg * std::pow(10, 0.1)) *
                  (1 + 1e-12));
  }
}

TEST(Profile, AveragesAroundTheAxisOfEvenSizesToo) {
  for (const int size : {64, 65}) {
    const int c = size / 2;
    const auto rings = radial_profile(
        grey(size, size, [&](int x, int y) { return std::hypot(x - c, y - c) <= 10 ? 2 : 0; }));
    for (const ProfileRing& ring : rings) {
      if (ring.outer_deg < 10 * kPitch_deg) {
        EXPECT_NEAR(ring.mean_per_steradian, 500, 1e-3);  // Single precision.
      } else if (ring.inner_deg > 10 * kPitch_deg) {
        EXPECT_EQ(ring.mean_per_steradian, 0);
      }
    }
  }
}

TEST(EncircledEnergy, OfAConstantIsTheCirclesArea) {
  const GlareTemplate t = grey(81, 101, [](int, int) { return 4; });
  for (const double radius_px : {1.0, 1.5, 3.3, 20.0, 40.5}) {
    const auto energy = encircled_energy(t, radius_px * kPitch_deg);
    ASSERT_TRUE(energy.has_value()) << radius_px;
    const double area = kPi * radius_px * radius_px * kPitch_rad * kPitch_rad;
    // Pixels on the circle are told by 16 x 16 places, some 1 / 16 pixel of the radius.
    EXPECT_NEAR(*energy / (1000 * area), 1, 0.02 / radius_px) << radius_px;
  }
}

TEST(EncircledEnergy, IsUnknownWithinAPixel) {
  const GlareTemplate t = grey(81, 101, [](int, int) { return 4; });
  EXPECT_FALSE(encircled_energy(t, 0.9 * kPitch_deg));
}

TEST(EncircledEnergy, IsUnknownWhereTheTemplateEnds) {
  EXPECT_FALSE(encircled_energy(grey(81, 101, [](int, int) { return 4; }), 40.6 * kPitch_deg));
  const GlareTemplate even = grey(80, 80, [](int, int) { return 4; });
  EXPECT_TRUE(encircled_energy(even, 39.5 * kPitch_deg));  // To the right of the axis.
  EXPECT_FALSE(encircled_energy(even, 39.6 * kPitch_deg));
}

TEST(Peak, IsTheBrightestPixel) {
  GlareTemplate t = grey(30, 20, [](int x, int y) { return x == 7 && y == 3 ? 5 : 1; });
  t.channels[2](20, 10) = 50;  // Blue, of little luminance: 0.0722 * 50 + 0.9278 = 4.54.
  const Peak brightest = peak(t);
  EXPECT_EQ(brightest.x, 7);
  EXPECT_EQ(brightest.y, 3);
  EXPECT_NEAR(brightest.luminance, 5, 1e-6);
}

TEST(MeanChromaticity, IsThatOfTheSum) {
  GlareTemplate t = grey(4, 4, [](int, int) { return 1; });
  EXPECT_NEAR(mean_chromaticity(t).x, 0.3127, 1e-6);
  EXPECT_NEAR(mean_chromaticity(t).y, 0.3290, 1e-6);
  t.channels[1] = t.channels[2] = Image<float>(4, 4);
  EXPECT_NEAR(mean_chromaticity(t).x, 0.64, 1e-6);  // Rec.709's red.
  t.color_space = xyz_color_space();
  t.channels[1] = t.channels[0];
  EXPECT_NEAR(mean_chromaticity(t).x, 0.5, 1e-12);
}

TEST(Profile, TheCieCurveIsTheEquationsMeanOverTheSamePixels) {
  const Straylight eye{24, 0.5};
  for (const int size : {101, 100}) {
    const GlareTemplate t = grey(size, size, [&](int x, int y) {
      const double sine = std::hypot(x - size / 2, y - size / 2) * kPitch_rad;
      return sine == 0 ? 0 : cie_general_glare(std::asin(sine) / kPi * 180, 24, 0.5) / 250;
    });
    const auto rings = radial_profile(t);
    const auto cie = cie_profile(t, rings, eye);
    ASSERT_EQ(cie.size(), rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
      EXPECT_EQ(cie[i].has_value(), rings[i].inner_deg > 0.09999) << i;
      if (cie[i]) {  // Points for pixel means: 3/8 (pitch / angle)^2 below, at 0.1 degrees 0.4 %.
        EXPECT_NEAR(rings[i].mean_per_steradian / *cie[i], 1, 4e-3) << rings[i].inner_deg;
      }
    }
  }
  EXPECT_THROW(cie_profile(grey(9, 9, [](int, int) { return 1; }), {}, {150, 0.5}), OptionError);
}

}  // namespace
}  // namespace glare
