#include "glare/photometry/luminous_intensity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "glare/base/error.h"
#include "support/beams.h"

namespace glare {
namespace {

using test::sampled;
using test::steps;
using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180;

Image<float> ramp(int width, int height) {
  Image<float> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image(x, y) = static_cast<float>(10 * x + y);
  return image;
}

TEST(LuminousIntensity, LinearBetweenMeasuredAngles) {
  for (const auto& h : {std::vector<double>{-2, 0, 2}, std::vector<double>{-2, -1.9, 3}}) {
    const LuminousIntensityDistribution lamp(PhotometricType::a, h, {-1, 0, 4, 5}, ramp(3, 4));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j)
        EXPECT_NEAR(
            lamp(h[static_cast<std::size_t>(i)], lamp.vertical_deg()[static_cast<std::size_t>(j)]),
            10 * i + j, 1e-12);  // Rounding.
    const double between = 0.25 * h[0] + 0.75 * h[1];
    EXPECT_NEAR(lamp(between, 1), 7.5 + 1.25, 1e-12);
    EXPECT_EQ(lamp(h[2] + 0.001, 0), 0);
    EXPECT_EQ(lamp(h[0] - 0.001, 0), 0);
    EXPECT_EQ(lamp(0, 5.001), 0);
    EXPECT_EQ(lamp(0, -1.001), 0);
    EXPECT_NEAR(lamp(h[2] + 1e-9, 5 + 1e-9), 23, 1e-6);  // A rounding error isn't outside.
    EXPECT_EQ(lamp(std::numeric_limits<double>::quiet_NaN(), 0), 0);
    EXPECT_EQ(lamp(0, std::numeric_limits<double>::infinity()), 0);
  }
}

TEST(LuminousIntensity, AnglesWrap) {
  const LuminousIntensityDistribution c(PhotometricType::c, {0, 90, 180, 270, 360}, {0, 90, 180},
                                        ramp(5, 3));
  EXPECT_NEAR(c(45, 90), 6, 1e-12);
  EXPECT_NEAR(c(45 + 360, 90), 6, 1e-12);
  EXPECT_NEAR(c(45 - 720, 90), 6, 1e-12);
  EXPECT_NEAR(c(-135, 270), 6, 1e-12);  // Past the lower pole and up on the other side.
  EXPECT_NEAR(c(225, -90), 6, 1e-12);
  EXPECT_EQ(c(-1e-14, 90), c(360, 90));
  const LuminousIntensityDistribution from_west(PhotometricType::c, {-180, 0, 180}, {0, 90},
                                                ramp(3, 2));
  EXPECT_NEAR(from_west(270, 0), 5, 1e-12);
  EXPECT_EQ(from_west(0, 91), 0);
  const LuminousIntensityDistribution a(PhotometricType::a, {-180, 0, 180}, {-90, 0, 90},
                                        ramp(3, 3));
  EXPECT_NEAR(a(0, 135), a(180, 45), 1e-12);
  const LuminousIntensityDistribution b(PhotometricType::b, {-90, 0, 90}, {-180, 0, 180},
                                        ramp(3, 3));
  EXPECT_NEAR(b(135, 0), b(45, 180), 1e-12);
}

TEST(LuminousIntensity, TypesAgreeOnOneBeam) {
  const Vector3 axis{0.1, -0.05, std::sqrt(1 - 0.0125)};
  const auto beam = [&](const Vector3& d) {
    const double cosine = axis[0] * d[0] + axis[1] * d[1] + axis[2] * d[2];
    return 1000 * std::exp(-8 * (1 - cosine)) * (1 + 0.3 * d[0] - 0.2 * d[1]);
  };
  const auto a = sampled(PhotometricType::a, steps(-180, 180, 361), steps(-90, 90, 181), beam);
  const auto b = sampled(PhotometricType::b, steps(-90, 90, 181), steps(-180, 180, 361), beam);
  const auto c = sampled(PhotometricType::c, steps(0, 360, 361), steps(0, 180, 181), beam);
  const auto c_ahead =
      sampled(PhotometricType::c, steps(0, 360, 361), steps(0, 180, 181), beam, true);
  const Mounting ahead{.gamma_zero_is_forward = true};
  for (double h = -179.7; h < 180; h += 7.3)
    for (double v = -89.6; v < 90; v += 5.9) {
      const Vector3 d = direction_from_angles(PhotometricType::a, h, v);
      // Linear interpolation in steps s errs by max I'' s^2 / 8 in each angle: I'' is 8000 cd/rad^2
      // at the peak, s^2 3.05e-4.
      const double tolerance = 2 * 8000 * 3.05e-4 / 8 * 1.3;
      EXPECT_NEAR(a.towards(d), beam(d), tolerance);
      EXPECT_NEAR(b.towards(d), beam(d), tolerance);
      EXPECT_NEAR(c.towards(d), beam(d), tolerance);
      EXPECT_NEAR(c_ahead.towards(d, ahead), beam(d), tolerance);
    }
}

TEST(LuminousIntensity, AnglesOfTheTypes) {
  const Vector3 d{0.3, 0.5, 0.7};
  const auto [h, v] = horizontal_vertical_deg(d);
  EXPECT_NEAR(h, std::atan2(0.3, 0.7) / kDegree, 1e-12);
  EXPECT_NEAR(v, std::asin(0.5 / std::sqrt(0.83)) / kDegree, 1e-12);
  const auto b = photometric_angles_deg(PhotometricType::b, d);
  EXPECT_NEAR(b[0], std::asin(0.3 / std::sqrt(0.83)) / kDegree, 1e-12);
  EXPECT_NEAR(b[1], std::atan2(0.5, 0.7) / kDegree, 1e-12);
  const auto c = photometric_angles_deg(PhotometricType::c, d);
  EXPECT_NEAR(c[0], std::atan2(0.7, 0.3) / kDegree, 1e-12);  // From the right to forward.
  EXPECT_NEAR(c[1], std::acos(-0.5 / std::sqrt(0.83)) / kDegree, 1e-12);
  const auto ahead = photometric_angles_deg(PhotometricType::c, d, true);
  EXPECT_NEAR(ahead[0], std::atan2(0.5, 0.3) / kDegree, 1e-12);  // From the right to up.
  EXPECT_NEAR(ahead[1], std::acos(0.7 / std::sqrt(0.83)) / kDegree, 1e-12);
  for (const auto type : {PhotometricType::a, PhotometricType::b, PhotometricType::c})
    for (const bool forward : {false, true}) {
      const auto angles = photometric_angles_deg(type, d, forward);
      const Vector3 back = direction_from_angles(type, angles[0], angles[1], forward);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(back[k], d[k] / std::sqrt(0.83), 1e-15);
    }
}

TEST(LuminousIntensity, PolesAreMeasuredPlaces) {
  const auto c = sampled(PhotometricType::c, steps(0, 360, 5), steps(0, 180, 3),
                         [](const Vector3& d) { return 2 + d[1]; });
  EXPECT_EQ(c.towards({0, -3, 0}), 1);
  EXPECT_EQ(c.towards({0, 3, 0}), 3);
  const auto a = sampled(PhotometricType::a, steps(-180, 180, 5), steps(-90, 90, 3),
                         [](const Vector3& d) { return 2 + d[1]; });
  EXPECT_EQ(a.towards({0, -1e-5, 0}), 1);
  EXPECT_EQ(a.towards({0, 1e5, 0}), 3);
}

/// A lamp whose intensities tell where they are.
LuminousIntensityDistribution lopsided_lamp() {
  return sampled(PhotometricType::a, steps(-60, 60, 121), steps(-60, 60, 121),
                 [](const Vector3& d) { return 10 + 3 * d[0] + 5 * d[1]; });
}

TEST(LuminousIntensity, MountingTurnsTheLamp) {
  const auto lamp = lopsided_lamp();
  for (const double angle : {-20.0, -3.0, 10.0, 25.0}) {
    // The vehicle's forward axis is seen from a lamp turned right at the left.
    EXPECT_NEAR(lamp.towards({0, 0, 1}, {.yaw_deg = angle}), lamp(-angle, 0), 1e-9);
    EXPECT_NEAR(lamp.towards({0, 0, 1}, {.pitch_deg = angle}), lamp(0, -angle), 1e-9);
    // A lamp rolled clockwise has its right lower than the vehicle's.
    const Vector3 right = direction_from_angles(PhotometricType::a, 30, 0);
    const Vector3 rolled{right[0] * std::cos(angle * kDegree), right[0] * std::sin(angle * kDegree),
                         right[2]};
    const auto [h, v] = horizontal_vertical_deg(rolled);
    EXPECT_NEAR(lamp.towards(right, {.roll_deg = angle}), lamp(h, v), 1e-9);
  }
}

/// Roll, then pitch, then yaw, by the matrices of a textbook, of the lamp's own axes.
TEST(LuminousIntensity, MountingOrder) {
  const Mounting mounting{.yaw_deg = 90, .pitch_deg = 90, .roll_deg = 90};
  // The lamp's forward axis: roll leaves it, pitch brings it up, and so yaw leaves it there. Its
  // right: roll turns it down, pitch turns down forward, yaw turns forward right.
  EXPECT_EQ(in_lamp_axes({0, 1, 0}, mounting), (Vector3{0, 0, 1}));
  EXPECT_EQ(in_lamp_axes({1, 0, 0}, mounting), (Vector3{1, 0, 0}));
  EXPECT_EQ(in_lamp_axes({0, 0, 1}, {.yaw_deg = 90}), (Vector3{-1, 0, 0}));
  EXPECT_EQ(in_lamp_axes({0, 0, 1}, {.pitch_deg = 90}), (Vector3{0, -1, 0}));
  EXPECT_EQ(in_lamp_axes({1, 0, 0}, {.roll_deg = 90}), (Vector3{0, 1, 0}));
}

TEST(LuminousIntensity, YawBringsAStreetLightsC0Ahead) {
  const auto lamp = sampled(PhotometricType::c, steps(0, 360, 9), steps(0, 180, 9),
                            [](const Vector3& d) { return 2 + d[0]; });
  EXPECT_NEAR(lamp.towards({0, 0, 1}, {.yaw_deg = -90}), lamp(0, 90), 1e-12);
}

std::string refusal(PhotometricType type, std::vector<double> h, std::vector<double> v,
                    Image<float> candela) {
  try {
    LuminousIntensityDistribution(type, std::move(h), std::move(v), std::move(candela));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(LuminousIntensity, RefusesBadGrids) {
  using enum PhotometricType;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(a, {0, 1}, {0, 1}, ramp(2, 2)), HasSubstr("accepted"));
  EXPECT_THAT(refusal(a, {0, 1}, {0, 1}, ramp(2, 3)), HasSubstr("2 x 3"));
  EXPECT_THAT(refusal(a, {0}, {0, 1}, ramp(1, 2)), HasSubstr("fewer than two horizontal"));
  EXPECT_THAT(refusal(a, {1, 1}, {0, 1}, ramp(2, 2)), HasSubstr("1 follows 1"));
  EXPECT_THAT(refusal(a, {0, 1}, {1, -2.5}, ramp(2, 2)), HasSubstr("-2.5 follows 1"));
  EXPECT_THAT(refusal(a, {0, nan}, {0, 1}, ramp(2, 2)), HasSubstr("isn't finite"));
  EXPECT_THAT(refusal(a, {0, 1}, {0, 91}, ramp(2, 2)), HasSubstr("-90 to 90"));
  EXPECT_THAT(refusal(b, {-91, 1}, {0, 1}, ramp(2, 2)), HasSubstr("-90 to 90"));
  EXPECT_THAT(refusal(b, {0, 1}, {-180, 181}, ramp(2, 2)), HasSubstr("more than 360"));
  EXPECT_THAT(refusal(c, {0, 1}, {-1, 1}, ramp(2, 2)), HasSubstr("0 to 180"));
  EXPECT_THAT(refusal(c, {0, 800}, {0, 1}, ramp(2, 2)), HasSubstr("-360 to 720"));
  Image<float> negative = ramp(2, 2);
  negative(1, 1) = -0.5f;
  EXPECT_THAT(refusal(a, {0, 1}, {0, 1}, negative), HasSubstr("negative"));
  negative(1, 1) = std::numeric_limits<float>::infinity();
  EXPECT_THAT(refusal(a, {0, 1}, {0, 1}, negative), HasSubstr("not finite"));
}

}  // namespace
}  // namespace glare
