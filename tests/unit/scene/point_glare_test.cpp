#include "glare/scene/point_glare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "glare/base/error.h"
#include "support/slow_veil.h"

namespace glare {
namespace {

constexpr double kDeg = 3.14159265358979323846 / 180;

/// X = Y = Z = value(radius in direction sine), at each pixel's centre.
GlareTemplate round_template(int size, double pitch_rad,
                             const std::function<double(double)>& value) {
  GlareTemplate t;
  t.color_space = xyz_color_space();
  t.pixel_pitch_rad = pitch_rad;
  t.normalization = Normalization::absolute;
  t.per_steradian = 1;
  for (auto& channel : t.channels) {
    channel = Image<float>(size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        channel(x, y) =
            static_cast<float>(value(pitch_rad * std::hypot(x - size / 2, y - size / 2)));
  }
  return t;
}

/// A core, steep like a pupil's, on a halo with rings.
double eye_like(double sine) {
  const double degrees = sine / kDeg;
  return 1 / (std::pow(degrees, 3) + 1e-3) * (1 + 0.3 * std::cos(8 * degrees));
}

Picture black(const Camera& camera) {
  Picture picture;
  picture.color_space = xyz_color_space();
  for (auto& channel : picture.channels) channel = Image<float>(camera.width, camera.height);
  return picture;
}

Vector3 direction(double right_deg, double up_deg) {
  return {std::tan(right_deg * kDeg), std::tan(up_deg * kDeg), 1};
}

Picture veil(const GlareTemplate& t, const Camera& camera, const Vector3& lamp, double lux = 1) {
  Picture picture = black(camera);
  const PointOfLight point{lamp, lux, GlareKernel(t, camera, picture.color_space)};
  add_glare(picture, camera, {&point, 1}, 2);
  return picture;
}

double energy(const GlareTemplate& t) {
  double sum = 0;
  for (const float v : t.channels[1].values()) sum += v;
  return sum * t.pixel_pitch_rad * t.pixel_pitch_rad;
}

/// What the picture has, by the areas of its pixels in direction sines about the lamp.
double energy(const Picture& picture, const Camera& camera, const Vector3& lamp) {
  double sum = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (picture.channels[1](x, y) != 0)
        sum += picture.channels[1](x, y) * test::sine_area(camera, lamp, x, y);
  return sum;
}

struct EnergyCase {
  double pitch_deg;  ///< Of the template.
  int size;
  Camera camera;
  Vector3 lamp;
};

class PointGlareEnergy : public testing::TestWithParam<EnergyCase> {};

INSTANTIATE_TEST_SUITE_P(
    Pictures, PointGlareEnergy,
    testing::Values(  // A picture of 0.073 degrees a pixel on its axis: coarser than the template,
        EnergyCase{0.011, 501, {960, 540, 70}, direction(0, 0)},
        EnergyCase{0.011, 501, {960, 540, 70}, direction(0.031, -0.017)},
        EnergyCase{0.011, 501, {960, 540, 70}, direction(25, 10)},
        EnergyCase{0.011, 501, {960, 540, 70}, direction(-30.013, -12)},
        EnergyCase{0.03, 201, {960, 540, 70}, direction(25, 10)},
        EnergyCase{0.06, 101, {960, 540, 70}, direction(25.02, 10.01)},
        EnergyCase{0.001, 1201, {960, 540, 70}, direction(25.02, 10.01)},
        // of 0.02 degrees and less: finer,
        EnergyCase{0.03, 101, {960, 540, 20}, direction(3.003, 1)},
        EnergyCase{0.2, 31, {960, 540, 20}, direction(3.003, 1)},
        // and of great width, where pixels at the side are small.
        EnergyCase{0.05, 101, {960, 540, 110}, direction(40, -15)}));

TEST_P(PointGlareEnergy, IsTheTemplates) {
  const EnergyCase& c = GetParam();
  const GlareTemplate t = round_template(c.size, c.pitch_deg * kDeg, eye_like);
  const Picture picture = veil(t, c.camera, c.lamp, 3);
  // 0.5 % is what is promised.
  EXPECT_NEAR(energy(picture, c.camera, c.lamp) / (3 * energy(t)), 1, 0.005);
}

TEST_P(PointGlareEnergy, OfOneBrightPixelIsTheTemplates) {
  const EnergyCase& c = GetParam();
  const GlareTemplate t =
      round_template(21, c.pitch_deg * kDeg, [](double s) { return s == 0 ? 1e4 : 0; });
  const Picture picture = veil(t, c.camera, c.lamp);
  EXPECT_NEAR(energy(picture, c.camera, c.lamp) / energy(t), 1, 0.005);
}

TEST_P(PointGlareEnergy, LiesAsTheReferenceSays) {
  const EnergyCase& c = GetParam();
  const GlareTemplate t = round_template(c.size, c.pitch_deg * kDeg, eye_like);
  const Picture picture = veil(t, c.camera, c.lamp);
  const auto place = c.camera.pixel_of(c.lamp).value();
  const double pixel_rad = 1 / c.camera.focal_length_px();
  const double softness = std::max(0.0, 1 - pixel_rad / t.pixel_pitch_rad);
  for (int dy = -60; dy <= 60; dy += 3)
    for (int dx = -60; dx <= 60; dx += 3) {
      const int x = static_cast<int>(place[0]) + dx, y = static_cast<int>(place[1]) + dy;
      if (x < 0 || y < 0 || x >= c.camera.width || y >= c.camera.height) continue;
      const auto s = test::sines_about(c.camera, c.lamp, x, y);
      const double border = (c.size / 2 - 1) * t.pixel_pitch_rad - 2 * pixel_rad;
      if (std::max(std::abs(s[0]), std::abs(s[1])) > border) continue;
      const double expected =
          test::slow_veil(t, c.camera, c.lamp, x, y, {c.pitch_deg < 0.01 ? 96 : 24, softness});
      // 1 % is what is promised where the template has rings of a few pixels.
      ASSERT_NEAR(picture.channels[1](x, y) / expected, 1, 0.01) << dx << ' ' << dy;
    }
}

/// 0 but for a ring of half a degree's width.
GlareTemplate ring(double sine) {
  return round_template(601, 0.02 * kDeg,
                        [=](double s) { return std::abs(s - sine) < 0.25 * kDeg ? 1. : 0.; });
}

/// Where along a row of pixels, by weight, the light is.
double middle_of(const Picture& picture, int row, int begin, int end) {
  double sum = 0, moment = 0;
  for (int x = begin; x < end; ++x) {
    sum += picture.channels[1](x, row);
    moment += 1.0 * x * picture.channels[1](x, row);
  }
  return moment / sum;
}

TEST(PointGlare, HasItsAngularSizeOnAndOffTheAxis) {
  const Camera camera{960, 541, 70};
  const double f = camera.focal_length_px();
  for (const double lamp_deg : {0., 25.}) {
    const Picture picture = veil(ring(std::sin(4 * kDeg)), camera, direction(lamp_deg, 0));
    // Seen from the eye, the ring is 4 degrees either side of the lamp.
    const auto column = [&](double degrees) {
      return 0.5 * (camera.width - 1) + f * std::tan(degrees * kDeg);
    };
    const int lamp = static_cast<int>(column(lamp_deg));
    const double left = middle_of(picture, 270, 0, lamp),
                 right = middle_of(picture, 270, lamp, 960);
    const double reach = column(lamp_deg + 4) - column(lamp_deg - 4);
    EXPECT_NEAR((right - left) / reach, 1, 0.005);
    EXPECT_NEAR(left, column(lamp_deg - 4), 0.1);
    EXPECT_NEAR(right, column(lamp_deg + 4), 0.1);
  }
}

TEST(PointGlare, HasItsRightAndDownInThePicture) {
  GlareTemplate t = round_template(101, 0.1 * kDeg, [](double) { return 0; });
  t.channels[1](50 + 30, 50 + 10) = 1;  // 3 degrees to the right, 1 down.
  const Camera camera{960, 540, 70};
  const Picture picture = veil(t, camera, {0, 0, 1});
  const auto pixels = picture.channels[1].values();
  const auto brightest = std::max_element(pixels.begin(), pixels.end()) - pixels.begin();
  const double f = camera.focal_length_px();
  EXPECT_NEAR(static_cast<double>(brightest % 960), 479.5 + f * std::tan(3 * kDeg), 1);
  EXPECT_NEAR(static_cast<double>(brightest / 960), 269.5 + f * std::tan(1 * kDeg), 1);
}

TEST(PointGlare, IsTheTemplateItselfWherePixelsMatch) {
  const Camera camera{41, 41, 4};
  const GlareTemplate t = round_template(31, 1 / camera.focal_length_px(), eye_like);
  const Picture picture = veil(t, camera, {0, 0, 1});
  // Sines for tangents: at 1.4 degrees they differ by 9e-4 of themselves, 0.013 of a pixel, in
  // which the veil changes by 0.4 % at most.
  for (int x = -14; x <= 14; ++x)
    EXPECT_NEAR(picture.channels[1](20 + x, 20) / t.channels[1](15 + x, 15), 1, 0.005) << x;
}

TEST(PointGlare, OfAnEvenTemplateIsEven) {
  struct Case {
    Camera camera;
    double pitch_deg;
  };
  // From pixels that are a hundred thousandth of the template's to some of 60 of them, and from
  // nearly none to nearly all of the half-space in a small picture.
  for (const Case& c :
       {Case{{107, 60, 0.0178}, 7}, Case{{107, 60, 20}, 1}, Case{{90, 60, 20}, 0.1},
        Case{{90, 60, 20}, 0.0038}, Case{{55, 60, 153}, 4}, Case{{64, 60, 170}, 2}}) {
    const GlareTemplate t = round_template(601, c.pitch_deg * kDeg, [](double) { return 1.; });
    const Vector3 lamp = c.camera.direction_of(40.3, 21.8);
    const Picture picture = veil(t, c.camera, lamp);
    for (int y = 0; y < c.camera.height; ++y)
      for (int x = 0; x < c.camera.width; ++x) {
        const float value = picture.channels[1](x, y);
        ASSERT_GE(value, 0.f) << x << ' ' << y;
        ASSERT_LE(value, 1.0001f) << x << ' ' << y;  // Weights in single precision.
      }
    EXPECT_NEAR(picture.channels[1](40, 22), 1, 1e-4);
    EXPECT_NEAR(picture.channels[1](41, 23), 1, 1e-4);
  }
}

TEST(PointGlare, GrowsWithTheIlluminance) {
  const Camera camera{320, 180, 40};
  const GlareTemplate t = round_template(201, 0.05 * kDeg, eye_like);
  const Picture one = veil(t, camera, direction(3, 1)), four = veil(t, camera, direction(3, 1), 4);
  for (int y = 0; y < 180; y += 7)
    for (int x = 0; x < 320; x += 3)  // By a power of two: exactly.
      ASSERT_EQ(four.channels[1](x, y), 4 * one.channels[1](x, y));
}

TEST(PointGlare, OfSeveralLampsIsTheSum) {
  const Camera camera{320, 180, 40};
  const GlareTemplate t = round_template(201, 0.05 * kDeg, eye_like);
  const Picture a = veil(t, camera, direction(-3, 0)), b = veil(t, camera, direction(2, 1), 0.7);
  Picture both = black(camera);
  for (auto& channel : both.channels)
    for (float& v : channel.values()) v = 0.5f;
  const GlareKernel kernel(t, camera, both.color_space);
  const std::array<PointOfLight, 3> points = {
      {{direction(-3, 0), 1, kernel}, {direction(2, 1), 0.7, kernel}, {{1, 0, 0}, 0, kernel}}};
  Picture result;
  with_glare(both, camera, points, result);
  add_glare(both, camera, points);
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 320; ++x) {
      const double sum = 0.5 + a.channels[1](x, y) + b.channels[1](x, y);
      ASSERT_NEAR(both.channels[1](x, y) / sum, 1, 1e-6);  // Roundings of single precision.
      ASSERT_EQ(both.channels[1](x, y), result.channels[1](x, y));
    }
}

TEST(PointGlare, IsInThePicturesColours) {
  GlareTemplate t = round_template(101, 0.1 * kDeg, eye_like);
  t.color_space = lin_rec709_color_space();
  for (float& v : t.channels[0].values()) v *= 2;
  const Camera camera{96, 54, 20};
  Picture xyz = black(camera), rgb = black(camera);
  rgb.color_space = lin_rec709_color_space();
  t.normalization = Normalization::peak;
  t.per_steradian = 30;
  for (Picture* picture : {&xyz, &rgb}) {
    const PointOfLight point{{0, 0, 1}, 1, GlareKernel(t, camera, picture->color_space)};
    add_glare(*picture, camera, {&point, 1});
  }
  const Vector3 color = {rgb.channels[0](30, 20), rgb.channels[1](30, 20), rgb.channels[2](30, 20)};
  EXPECT_NEAR(color[0] / color[1], 2, 1e-5);
  const Xyz expected = rgb.color_space.xyz_from_rgb() * color;
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(xyz.channels[k](30, 20) / expected[k], 1, 1e-5);
  EXPECT_NEAR(color[1] / test::slow_veil(t, camera, {0, 0, 1}, 30, 20), 30 / 2., 0.15);
}

TEST(PointGlare, IsTheSameForAnyNumberOfThreads) {
  const Camera camera{320, 181, 40};
  const GlareTemplate t = round_template(401, 0.05 * kDeg, eye_like);
  Picture one = black(camera), many = black(camera);
  const PointOfLight point{direction(3, 1), 1, GlareKernel(t, camera, one.color_space)};
  add_glare(one, camera, {&point, 1}, 1);
  add_glare(many, camera, {&point, 1}, 8);
  EXPECT_TRUE(std::equal(one.channels[1].values().begin(), one.channels[1].values().end(),
                         many.channels[1].values().begin()));
}

TEST(PointGlare, ComesFromBeyondTheBorders) {
  const Camera camera{320, 180, 40};
  const GlareTemplate t = round_template(801, 0.05 * kDeg, eye_like);
  const Vector3 lamp = direction(-27, 2);  // 7 degrees outside.
  const Picture picture = veil(t, camera, lamp);
  EXPECT_NEAR(picture.channels[1](5, 80) / test::slow_veil(t, camera, lamp, 5, 80), 1, 0.01);
  EXPECT_EQ(picture.channels[1](310, 80), 0);  // Beyond the template's 20 degrees.
  // One to the side and one behind the viewer reach nothing with this template.
  for (const Vector3& direction : {Vector3{1, 0, 0}, Vector3{0, 0, -1}, Vector3{0.1, 0, -1}}) {
    const Picture nothing = veil(t, camera, direction);
    for (const float v : nothing.channels[1].values()) ASSERT_EQ(v, 0);
  }
}

TEST(PointGlare, HasThePeakAskedFor) {
  GlareTemplate t = round_template(101, 0.1 * kDeg, eye_like);
  t.per_steradian = 0.25;
  EXPECT_NEAR(illuminance_for_peak_lux(t, 80), 80 / (0.25 * t.channels[1](50, 50)), 1e-9);
  const GlareTemplate dark = round_template(11, 0.1 * kDeg, [](double) { return 0; });
  EXPECT_THROW(illuminance_for_peak_lux(dark, 1), InputError);
}

TEST(PointGlare, IsRefusedWhereItHasNoSense) {
  const Camera camera{320, 180, 40};
  GlareTemplate t = round_template(11, 0.1 * kDeg, eye_like);
  Picture picture = black(camera);
  const auto add = [&](const PointOfLight& point, const Camera& seen_by) {
    add_glare(picture, seen_by, {&point, 1});
  };
  const GlareKernel kernel(t, camera, picture.color_space);
  EXPECT_THROW(add({{0, 0, 0}, 1, kernel}, camera), OptionError);
  EXPECT_THROW(add({{0, 0, 1}, -1, kernel}, camera), OptionError);
  EXPECT_THROW(add({{0, 0, 1}, std::numeric_limits<double>::infinity(), kernel}, camera),
               OptionError);
  EXPECT_THROW(add({{0, 0, 1}, 1, kernel}, {321, 180, 40}), OptionError);
  EXPECT_THROW(add({{0, 0, 1}, 1, kernel}, {320, 180, 50}), OptionError);  // Larger pixels.
  t.pixel_pitch_rad = 0;
  EXPECT_THROW(GlareKernel(t, camera, picture.color_space), InputError);
  EXPECT_THROW(GlareKernel(GlareTemplate(), camera, picture.color_space), InputError);
}

}  // namespace
}  // namespace glare
