#include "glare/scene/lamp_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "glare/base/error.h"

namespace glare {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// 1000 cd ahead, 10 cd more for each degree to the right and 1 for each up; within 40 degrees.
LuminousIntensityDistribution slanted_beam() {
  Image<float> candela(2, 2);
  candela(0, 0) = 1000 - 400 - 40;
  candela(1, 0) = 1000 + 400 - 40;
  candela(0, 1) = 1000 - 400 + 40;
  candela(1, 1) = 1000 + 400 + 40;
  return {PhotometricType::a, {-40, 40}, {-40, 40}, candela};
}

TEST(LampLight, FallsWithTheSquareOfTheDistance) {
  for (const double d : {1., 3., 50., 1000.}) {
    const LightAtEye light = light_at_eye(slanted_beam(), {{0, 0, d}, {}});
    EXPECT_DOUBLE_EQ(light.intensity_cd, 1000);
    EXPECT_DOUBLE_EQ(light.illuminance_lux, 1000 / (d * d));
    EXPECT_DOUBLE_EQ(light.distance_m, d);
  }
  // In any direction: at twice the distance, exactly a quarter.
  const LightAtEye near = light_at_eye(slanted_beam(), {{3, 1, 20}, {}});
  const LightAtEye far = light_at_eye(slanted_beam(), {{6, 2, 40}, {}});
  EXPECT_EQ(near.intensity_cd, far.intensity_cd);
  EXPECT_EQ(near.illuminance_lux, 4 * far.illuminance_lux);
}

TEST(LampLight, FallsWithTheCosineToTheLineOfSight) {
  const Vector3 lamp = {0, 0, 10};
  for (const double degrees : {0., 20., 60., 89.}) {
    const Vector3 sight = {std::sin(degrees * kDegree), 0, std::cos(degrees * kDegree)};
    EXPECT_NEAR(illuminance_at_eye_lux(500, lamp, sight), 5 * std::cos(degrees * kDegree), 1e-14);
  }
  EXPECT_EQ(illuminance_at_eye_lux(500, lamp, {0, 0, -1}), 0);
  EXPECT_EQ(illuminance_at_eye_lux(500, {0, 0, -10}), 0);
  EXPECT_EQ(illuminance_at_eye_lux(500, lamp, {0, 0, 3}), 5);  // Of any length.
}

TEST(LampLight, GoesToTheEyeFromTheOncomingCarsOwnSides) {
  // A lamp on the viewer's left shines to the viewer's right, which is the left of a car that faces
  // the viewer.
  const double d = 20;
  const Vector3 lamp = {-d * std::tan(5 * kDegree), 0, d};
  const LightAtEye light = light_at_eye(slanted_beam(), {lamp, {}});
  EXPECT_NEAR(light.horizontal_deg, -5, 1e-12);
  EXPECT_NEAR(light.vertical_deg, 0, 1e-12);
  EXPECT_NEAR(light.intensity_cd, 950, 1e-3);  // Single precision in the table.
  EXPECT_LT(light.direction[0], 0);
}

TEST(LampLight, GoesUpToAnEyeAboveTheLamp) {
  const LightAtEye light = light_at_eye(slanted_beam(), {{0, -2, 2 / std::tan(3 * kDegree)}, {}});
  EXPECT_NEAR(light.vertical_deg, 3, 1e-12);
  EXPECT_NEAR(light.intensity_cd, 1003, 1e-3);
}

TEST(LampLight, TurnsWithTheCar) {
  // The car turns 10 degrees to its right: the eye ahead of it before is now 10 to its left.
  const LightAtEye light = light_at_eye(slanted_beam(), {{0, 0, 20}, {.yaw_deg = 10}});
  EXPECT_NEAR(light.horizontal_deg, -10, 1e-12);
  EXPECT_NEAR(light.intensity_cd, 900, 1e-3);
  const LightAtEye raised = light_at_eye(slanted_beam(), {{0, 0, 20}, {.pitch_deg = 4}});
  EXPECT_NEAR(raised.vertical_deg, -4, 1e-12);
  EXPECT_NEAR(raised.intensity_cd, 996, 1e-3);
}

TEST(LampLight, IsDimmed) {
  const LightAtEye light = light_at_eye(slanted_beam(), {{0, 0, 10}, {}}, 0.25);
  EXPECT_DOUBLE_EQ(light.intensity_cd, 250);
  EXPECT_DOUBLE_EQ(light.illuminance_lux, 2.5);
}

TEST(LampLight, IsRefusedWhereItHasNoSense) {
  const auto beam = slanted_beam();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(light_at_eye(beam, {{0, 0, 0}, {}}), OptionError);
  EXPECT_THROW(light_at_eye(beam, {{0, kNan, 1}, {}}), OptionError);
  EXPECT_THROW(light_at_eye(beam, {{0, 0, 1}, {}}, -1), OptionError);
  EXPECT_THROW(light_at_eye(beam, {{0, 0, 1}, {}}, 1, {0, 0, 0}), OptionError);
}

}  // namespace
}  // namespace glare
