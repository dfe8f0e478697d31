#include "glare/convolution/point_sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glare/spectrum/lamps.h"
#include "support/refusals.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr double kSigma_rad = 2.4e-3;
constexpr PixelScale kScale{1e-3, 1.25};

/// The integral of a normal distribution with that sigma.
double normal_share(double from, double to) {
  const double unit = kSigma_rad * std::sqrt(2.0);
  return 0.5 * (std::erf(to / unit) - std::erf(from / unit));
}

/// White light, four fifths of it in a Gaussian, by exact means; the rest goes beyond the pixels.
GlareTemplate gaussian_template(double pitch_rad, int width, int height) {
  GlareTemplate t;
  const auto share = [&](int i, int size) {
    const double middle = (i - size / 2) * pitch_rad;
    return normal_share(middle - pitch_rad / 2, middle + pitch_rad / 2);
  };
  t.channels.fill(test::picture(
      width, height, [&](int x, int y) { return 0.8 * share(x, width) * share(y, height); }));
  t.pixel_pitch_rad = pitch_rad;
  t.per_steradian = 1 / (pitch_rad * pitch_rad);
  t.light_xyz = t.color_space.white_xyz();
  return t;
}

GlareTemplate sharp_template() {
  GlareTemplate t = gaussian_template(0.4e-3, 41, 38);
  t.channels[0](20, 19) += 0.1f;
  t.channels[2](23, 12) += 0.05f;
  return t;
}

Picture black(int width, int height) {
  Picture picture;
  picture.channels.fill(Image<float>(width, height));
  return picture;
}

double sum(const Image<float>& image) {
  double result = 0;
  for (const float value : image.values()) result += value;
  return result;
}

TEST(PointSources, AtAPixelsCentreAPointGivesTheKernel) {
  const GlareTemplate t = sharp_template();
  const PixelKernel kernel = pixel_kernel(t, kScale, lin_rec709_color_space());
  Picture picture = black(40, 33);
  const PointSource point{17, 9, {100, 50, 25}};
  for (std::size_t k = 0; k < 3; ++k) picture.channels[k](17, 9) = point.light[k];
  add_point_glare(picture, std::span(&point, 1), t, kScale);
  for (std::size_t k = 0; k < 3; ++k)
    for (int y = 0; y < 33; ++y)
      for (int x = 0; x < 40; ++x) {
        const int i = x - 17 + kernel.width() / 2, j = y - 9 + kernel.height() / 2;
        const bool inside = i >= 0 && i < kernel.width() && j >= 0 && j < kernel.height();
        const double share =
            (inside ? kernel.channels[k](i, j) : 0.f) + (x == 17 && y == 9 ? kernel.kept[k] : 0);
        EXPECT_NEAR(picture.channels[k](x, y), point.light[k] * share, 1e-5) << x << ", " << y;
      }
}

TEST(PointSources, AtPixelsCentresPointsAreAsTheConvolution) {
  const GlareTemplate t =
      make_template(test::small_pupil(), blackbody(3000), test::small_options());
  const PixelScale scale{0.7 * t.pixel_pitch_rad, 1};
  Picture convolved = black(60, 45);
  const PointSource points[] = {{30, 22, {1, 2, 3}}, {0, 44, {9, 3, 1}}, {59, 7, {0, 5, 2}}};
  for (const PointSource& point : points)
    for (std::size_t k = 0; k < 3; ++k)
      convolved.channels[k](static_cast<int>(point.x_px), static_cast<int>(point.y_px)) =
          point.light[k];
  ApplyGlareOptions options;
  options.strength = 0.7;
  options.only_glare = true;
  apply_glare(convolved, GlareFilter(pixel_kernel(t, scale, convolved.color_space), 60, 45),
              options);
  PointGlareOptions point_options;
  point_options.strength = 0.7;
  Picture added = black(60, 45);
  add_point_glare(added, points, t, scale, point_options);
  for (std::size_t k = 0; k < 3; ++k) {
    double difference = 0, all = 0;
    for (std::size_t i = 0; i < added.channels[k].values().size(); ++i) {
      const double exact = added.channels[k].values()[i];
      difference += std::abs(convolved.channels[k].values()[i] - exact);
      all += std::abs(exact);
    }
    EXPECT_GT(all, 0.1);
    EXPECT_LT(difference, 1e-5 * all);  // Transforms in single precision.
  }
}

TEST(PointSources, BetweenPixelsTheMeansAreThoseAboutThePoint) {
  // The template's pixels show the Gaussian well, whether finer or coarser than the picture's.
  for (const double pitch_rad : {0.37e-3, 1.3e-3})
    for (const auto& [x0, y0] : {std::array{20.3, 15.0}, {19.5, 14.75}, {20.0, 15.49}}) {
      Picture picture = black(40, 31);
      const PointSource point{x0, y0, {1, 1, 1}};
      PointGlareOptions options;
      options.points_are_new = true;
      options.strength = 2;  // Of the change: K v + (kept - 1) v.
      const auto size = static_cast<int>(30e-3 / pitch_rad) | 1;
      add_point_glare(picture, std::span(&point, 1), gaussian_template(pitch_rad, size, size),
                      kScale, options);
      for (int y = 0; y < 31; ++y)
        for (int x = 0; x < 40; ++x) {
          const auto share = [](double offset, double pitch) {
            return normal_share((offset - 0.5) * pitch, (offset + 0.5) * pitch);
          };
          const double glare = 0.8 * share(x - x0, 1e-3) * share(y - y0, 1e-3 / 1.25);
          const double own =
              std::max(0.0, 1 - std::abs(x - x0)) * std::max(0.0, 1 - std::abs(y - y0));
          // Cubics of a Gaussian that is sampled every 0.15 and every 0.54 of its sigma; the
          // largest value is 0.07.
          const double tolerance = pitch_rad < 1e-3 ? 2e-5 : 2e-4;
          EXPECT_NEAR(picture.channels[1](x, y), 2 * glare + (1 - 2 * 0.8) * own, tolerance);
        }
    }
}

TEST(PointSources, TheCentreOfLightIsThePoint) {
  // From cores that are far narrower than a pixel to ones of several pixels.
  for (const double sigma_px : {0.1, 0.3, 0.6, 1.0, 3.0}) {
    const GlareTemplate t = gaussian_template(kSigma_rad / sigma_px, 61, 61);
    for (const double fraction : {0.22, 0.5, 0.73}) {
      Picture picture = black(62, 62);
      const PointSource point{30 + fraction, 31 - fraction, {1, 1, 1}};
      PointGlareOptions options;
      options.points_are_new = true;
      add_point_glare(picture, std::span(&point, 1), t, {t.pixel_pitch_rad, 1}, options);
      double x_sum = 0, y_sum = 0;
      for (int y = 0; y < 62; ++y)
        for (int x = 0; x < 62; ++x) {
          const double light = picture.channels[0](x, y);
          x_sum += light * x;
          y_sum += light * y;
        }
      EXPECT_NEAR(x_sum, point.x_px, 0.01) << sigma_px;  // All the light is in the picture: 1.
      EXPECT_NEAR(y_sum, point.y_px, 0.01) << sigma_px;
    }
  }
}

TEST(PointSources, LightIsMovedAndNewLightIsAdded) {
  const GlareTemplate t = sharp_template();
  const PointSource points[] = {{30.2, 25.7, {3, 2, 1}}, {33, 31.5, {0.5f, 0, 7}}};
  for (const bool are_new : {false, true}) {
    Picture picture = black(64, 60);
    PointGlareOptions options;
    options.points_are_new = are_new;
    add_point_glare(picture, points, t, kScale, options);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(sum(picture.channels[k]), are_new ? points[0].light[k] + points[1].light[k] : 0,
                  1e-5);
  }
}

TEST(PointSources, BeyondTheBorderPointsGiveWhatFallsOnThePicture) {
  const GlareTemplate t = sharp_template();
  const PointSource inside[] = {
      {8.3, 14.6, {5, 4, 3}}, {61, 20.5, {1, 2, 3}}, {9.5, 30, {1, 1, 1}}};
  Picture large = black(70, 50);
  add_point_glare(large, inside, t, kScale);
  std::vector<PointSource> outside(std::begin(inside), std::end(inside));
  for (PointSource& point : outside) {
    point.x_px -= 10;
    point.y_px -= 12;
  }
  outside.push_back({1e300, -1e300, {1, 1, 1}});
  outside.push_back({-500, 3, {1, 1, 1}});
  Picture small = black(45, 20);
  add_point_glare(small, outside, t, kScale);
  for (std::size_t k = 0; k < 3; ++k) {
    const Image<float> part = test::cropped(large.channels[k], 10, 12, 45, 20);
    for (int y = 0; y < 20; ++y)
      // Fractions that aren't the same to the last bit.
      for (int x = 0; x < 45; ++x) EXPECT_NEAR(small.channels[k](x, y), part(x, y), 1e-6);
  }
}

TEST(PointSources, AreTheSameForAnyNumberOfThreadsAndGrow) {
  const GlareTemplate t = sharp_template();
  std::vector<PointSource> points;
  for (int i = 0; i < 60; ++i)
    points.push_back({7.0 * i / 11, 3 + 0.5 * i, {1, 0.1f * static_cast<float>(i), 2}});
  const auto with = [&](int threads, double strength) {
    Picture picture = black(50, 40);
    PointGlareOptions options;
    options.threads = threads;
    options.strength = strength;
    add_point_glare(picture, points, t, kScale, options);
    return picture;
  };
  const Picture one = with(1, 1), four = with(4, 1), strong = with(2, 3);
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < one.channels[k].values().size(); ++i) {
      EXPECT_EQ(one.channels[k].values()[i], four.channels[k].values()[i]);
      EXPECT_NEAR(strong.channels[k].values()[i], 3 * one.channels[k].values()[i], 1e-5);
    }
}

TEST(PointSources, RefusesWhatIsNotFinite) {
  const GlareTemplate t = sharp_template();
  Picture picture = black(8, 8);
  const auto refuse = [&](const PointSource& point) {
    test::expect_refused([&] { add_point_glare(picture, std::span(&point, 1), t, kScale); },
                         "finite");
  };
  refuse({std::numeric_limits<double>::quiet_NaN(), 0, {}});
  refuse({0, HUGE_VAL, {}});
  refuse({0, 0, {0, HUGE_VALF, 0}});
  PointGlareOptions options;
  options.strength = -1;
  test::expect_refused([&] { add_point_glare(picture, {}, t, kScale, options); }, "strength");
  options = {};
  options.progress = [](double) { return false; };
  const PointSource point{3, 3, {1, 1, 1}};
  EXPECT_THROW(add_point_glare(picture, std::span(&point, 1), t, kScale, options), Cancelled);
  EXPECT_EQ(sum(picture.channels[0]), 0);
}

TEST(BrightPoints, AreAsFewAsHoldTheShareInRowOrder) {
  Picture light = black(50, 30);
  light.channels.fill(test::picture(50, 30, [](int x, int y) { return 1e-4 * ((x + y) % 3); }));
  light.channels[0](40, 3) = 50;
  light.channels[1](40, 3) = 20;
  light.channels[1](7, 20) = 30;
  light.channels[2](8, 20) = 40;
  light.channels[0](9, 25) = 0.01f;
  const auto points = bright_points(light, 0.99, 10);
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 3U);
  EXPECT_EQ((*points)[0].x_px, 40);
  EXPECT_EQ((*points)[0].y_px, 3);
  EXPECT_EQ((*points)[0].light[0], 50);
  EXPECT_EQ((*points)[1].x_px, 7);
  EXPECT_EQ((*points)[2].light[2], 40);
  EXPECT_FALSE(bright_points(light, 0.99, 2));
  // Two thirds of the pixels have light, and (7, 20).
  EXPECT_FALSE(bright_points(light, 1, 1000));
  EXPECT_EQ(bright_points(light, 1, 1001).value().size(), 1001U);
  EXPECT_EQ(bright_points(light, 0, 0)->size(), 0U);
}

TEST(BrightPoints, OfEqualOnesTheFirstAreTaken) {
  Picture light = black(200, 100);
  light.channels[1] = Image<float>(200, 100, 1.f);
  const auto points = bright_points(light, 0.01, 300);
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 200U);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ((*points)[i].x_px, static_cast<double>(i));
    EXPECT_EQ((*points)[i].y_px, 0);
  }
}

TEST(FewPoints, AreNoneWhereThePictureHasMoreOrALightBorderGoesOn) {
  Picture light = black(40, 30);
  for (auto& channel : light.channels) channel(20, 15) = 1000;
  light.channels[0](3, 4) = 0.4f;  // 0.04 % of the light.
  ASSERT_TRUE(few_points(light, Edge::extend));
  EXPECT_EQ(few_points(light, Edge::extend)->size(), 1U);
  light.channels[1](0, 29) = 0.1f;
  EXPECT_FALSE(few_points(light, Edge::extend));
  EXPECT_TRUE(few_points(light, Edge::black));
  light.channels.fill(Image<float>(40, 30, 1.f));
  EXPECT_FALSE(few_points(light, Edge::black));
}

TEST(BrightPoints, WhatIsNoLightIsNone) {
  Picture light = black(5, 5);
  EXPECT_EQ(bright_points(light, 1, 0)->size(), 0U);
  light.channels[0](1, 1) = std::nanf("");
  light.channels[1](2, 1) = HUGE_VALF;
  light.channels[2](3, 1) = -4;
  light.channels[1](3, 1) = 2;
  const auto points = bright_points(light, 1, 10);
  ASSERT_TRUE(points);
  ASSERT_EQ(points->size(), 1U);
  EXPECT_EQ((*points)[0].light, (std::array<float, 3>{0, 2, 0}));
  for (const double share : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(bright_points(light, share, 10), OptionError);
}

}  // namespace
}  // namespace glare
