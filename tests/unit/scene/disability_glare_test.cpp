#include "glare/scene/disability_glare.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "glare/base/error.h"

namespace glare {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Y per steradian is 2 / (radius in degrees + 1), stored as half of it; 201 x 101 pixels of 0.1
/// degrees.
GlareTemplate cone() {
  GlareTemplate t;
  t.color_space = xyz_color_space();
  t.pixel_pitch_rad = 0.1 * kDegree;
  t.per_steradian = 2;
  for (auto& channel : t.channels) {
    channel = Image<float>(201, 101);
    for (int y = 0; y < 101; ++y)
      for (int x = 0; x < 201; ++x)
        channel(x, y) = static_cast<float>(1 / (0.1 * std::hypot(x - 100, y - 50) + 1));
  }
  return t;
}

TEST(DisabilityGlare, OfATemplateIsItsMeanAtTheAngle) {
  const GlareTemplate t = cone();
  for (const double degrees : {1., 2.5, 4.9}) {
    const double sine_deg = std::sin(degrees * kDegree) / kDegree;
    // Linear between pixels: pitch^2 / 8 times the curvature 2 / (r + 1)^3 is 1e-3 at most.
    EXPECT_NEAR(template_veil_per_lux(t, degrees).value(), 2 / (sine_deg + 1), 1e-3);
  }
  EXPECT_FLOAT_EQ(static_cast<float>(template_veil_per_lux(t, 0).value()), 2.f);
}

TEST(DisabilityGlare, IsUnknownBeyondATemplatesField) {
  const GlareTemplate t = cone();
  EXPECT_TRUE(template_veil_per_lux(t, 5.0).has_value());
  EXPECT_FALSE(
      template_veil_per_lux(t, 5.02).has_value());  // Its height is 50 pixels from the axis.
  EXPECT_FALSE(template_veil_per_lux(t, 120).has_value());  // Whose sine is that of 60.
  EXPECT_FALSE(template_veil_per_lux(t, -1).has_value());
}

TEST(DisabilityGlare, OfSeveralLampsIsTheSum) {
  // 10 / 8 + (5 / 4 + 0.5 * 0.1 / 2) * 2 + 0.00125 at 2 degrees and 62.5 years, pigment 0.5;
  // 10 / 1000 + (5 / 100 + 0.05 / 10) * 2 + 0.00125 at 10.
  const std::array<GlareSource, 3> sources = {{{0.5, 2}, {3, 10}, {0, 0}}};
  EXPECT_NEAR(cie_veiling_luminance(sources, {62.5, 0.5}).value(), 0.5 * 3.80125 + 3 * 0.12125,
              1e-12);
}

TEST(DisabilityGlare, IsUnknownBeyondTheEquationsRange) {
  const std::array<GlareSource, 1> near = {{{0.5, 0.05}}};
  EXPECT_FALSE(cie_veiling_luminance(near, {}).has_value());
  EXPECT_THROW(cie_veiling_luminance(near, {-1, 0.5}), OptionError);
}

TEST(DisabilityGlare, TakesTheAngleFromTheGaze) {
  LightAtEye light;
  light.direction = {std::sin(3 * kDegree), 0, std::cos(3 * kDegree)};
  light.illuminance_lux = 0.7;
  EXPECT_NEAR(glare_source(light).angle_deg, 3, 1e-12);
  EXPECT_NEAR(glare_source(light, {0, 5, 0}).angle_deg, 90, 1e-12);
  EXPECT_EQ(glare_source(light).illuminance_lux, 0.7);
  EXPECT_NEAR(angle_between_deg({1, 0, 0}, {-2, 0, 0}), 180, 1e-12);
}

TEST(DisabilityGlare, RaisesTheThreshold) {
  // By hand: 65 * 0.3 / 2^0.8 = 19.5 / 1.7411011; 95 * 0.3 / 10^1.05 = 28.5 / 11.2201845.
  EXPECT_NEAR(threshold_increment_percent(0.3, 2).value(), 11.199810, 1e-5);
  EXPECT_NEAR(threshold_increment_percent(0.3, 10).value(), 2.540066, 1e-5);
  EXPECT_NEAR(threshold_increment_percent(0.1, 1).value(), 6.5, 1e-12);
  // The two meet at 5 cd/m^2 within 2.5 %.
  EXPECT_NEAR(threshold_increment_percent(1, 5).value() /
                  threshold_increment_percent(1, std::nextafter(5, 6)).value(),
              1, 0.03);
  EXPECT_FALSE(threshold_increment_percent(0.3, 0.05).has_value());
  EXPECT_THROW(threshold_increment_percent(-1, 1), OptionError);
}

TEST(DisabilityGlare, AveragesBySolidAngle) {
  const Camera camera{81, 61, 120};
  Picture picture;
  picture.color_space = lin_rec709_color_space();
  for (auto& channel : picture.channels) channel = Image<float>(81, 61, 0.5f);
  EXPECT_NEAR(average_luminance(picture, camera), 0.5, 1e-6);
  // Luminance 1 in the middle column, 0 elsewhere: its share of the solid angle. That of a
  // rectangle of half sides a, b at distance 1 is 4 asin(a b / sqrt((1 + a^2) (1 + b^2))).
  const auto solid_angle = [](double a, double b) {
    return 4 * std::asin(a * b / std::sqrt((1 + a * a) * (1 + b * b)));
  };
  for (auto& channel : picture.channels) {
    channel = Image<float>(81, 61);
    for (int y = 0; y < 61; ++y) channel(40, y) = 1;
  }
  const double f = camera.focal_length_px();
  const double expected = solid_angle(0.5 / f, 30.5 / f) / solid_angle(40.5 / f, 30.5 / f);
  EXPECT_NEAR(average_luminance(picture, camera) / expected, 1, 1e-3);  // Pixels' middles.
  EXPECT_THROW(average_luminance(picture, {80, 61, 120}), OptionError);
}

}  // namespace
}  // namespace glare
