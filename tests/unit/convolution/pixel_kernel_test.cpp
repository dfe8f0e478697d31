#include "glare/convolution/pixel_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "glare/spectrum/lamps.h"
#include "glare/template/resampled.h"
#include "support/refusals.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr double kSinglePrecision = 1e-6;

double sum(const Image<float>& image) {
  double result = 0;
  for (const float value : image.values()) result += value;
  return result;
}

/// A round, soft template of white light, with a pitch of 1 mrad.
GlareTemplate soft_template(int width, int height) {
  GlareTemplate t;
  t.color_space = lin_rec709_color_space();
  for (std::size_t k = 0; k < 3; ++k)
    t.channels[k] = test::picture(width, height, [&](int x, int y) {
      const double u = x - width / 2, v = y - height / 2;
      return std::exp(-(u * u + v * v) / (18. + 4. * static_cast<double>(k)));
    });
  t.pixel_pitch_rad = 1e-3;
  t.per_steradian = 1.2e4;
  t.light_xyz = t.color_space.white_xyz();
  return t;
}

/// The mean of the squares of the distances from the axis, across and down, in pixels.
std::array<double, 2> spread(const Image<float>& kernel) {
  double across = 0, down = 0;
  for (int y = 0; y < kernel.height(); ++y)
    for (int x = 0; x < kernel.width(); ++x) {
      across += kernel(x, y) * std::pow(x - kernel.width() / 2, 2);
      down += kernel(x, y) * std::pow(y - kernel.height() / 2, 2);
    }
  return {across / sum(kernel), down / sum(kernel)};
}

TEST(PixelKernel, IsTheTemplateItselfAtItsPitch) {
  for (const auto& [width, height] : {std::array{21, 15}, {20, 15}, {21, 16}, {12, 30}}) {
    const GlareTemplate t = soft_template(width, height);
    const PixelKernel kernel = pixel_kernel(t, {1e-3, 1}, t.color_space);
    const int left = kernel.width() / 2 - width / 2, top = kernel.height() / 2 - height / 2;
    ASSERT_GE(left, 0);
    ASSERT_GE(top, 0);
    EXPECT_EQ(kernel.width() % 2 + kernel.height() % 2, 2);
    for (std::size_t k = 0; k < 3; ++k) {
      const double unit = t.per_steradian * 1e-6;
      double inside = 0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          inside += kernel.channels[k](left + x, top + y);
          EXPECT_NEAR(kernel.channels[k](left + x, top + y) / (unit * t.channels[k](x, y)), 1,
                      kSinglePrecision);
        }
      EXPECT_NEAR(kernel.captured[k] / (unit * sum(t.channels[k])), 1, 1e-12);
      EXPECT_NEAR(sum(kernel.channels[k]), inside, 1e-12);  // Nothing around it.
      EXPECT_NEAR(kernel.captured[k] + kernel.kept[k], 1, 1e-12);
    }
  }
}

TEST(PixelKernel, APitchAsAFileHasItIsEqual) {
  const GlareTemplate t = soft_template(21, 15);
  const PixelKernel exact = pixel_kernel(t, {1e-3, 1}, t.color_space);
  const PixelKernel near = pixel_kernel(t, {static_cast<float>(1e-3), 1}, t.color_space);
  EXPECT_EQ(near.width(), 21);
  EXPECT_NEAR(near.channels[0](12, 9) / exact.channels[0](12, 9), 1, kSinglePrecision);
}

TEST(PixelKernel, KeepsTheLightAtAnyRatioAndShift) {
  const GlareTemplate t = soft_template(24, 33);
  for (double ratio = 0.17; ratio < 6; ratio *= 1.31)
    for (const double shift : {0., 0.4}) {
      PixelKernelOptions options;
      options.shift_x_px = shift;
      options.shift_y_px = -shift / 2;
      const PixelKernel kernel = pixel_kernel(t, {1e-3 * ratio, 1.1}, t.color_space, options);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(sum(kernel.channels[k]) / kernel.captured[k], 1, kSinglePrecision) << ratio;
    }
}

TEST(PixelKernel, ATemplateOfHalfThePitchIsHalfAsWide) {
  GlareTemplate t = soft_template(41, 41);
  const auto wide = spread(pixel_kernel(t, {1e-3, 1}, t.color_space).channels[0]);
  t.pixel_pitch_rad /= 2;
  const auto narrow = spread(pixel_kernel(t, {1e-3, 1}, t.color_space).channels[0]);
  // Means over pixels of side 1 are wider by 1/12, those of the template's own by 1/48.
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(narrow[k], wide[k] / 4 + 1. / 16, 5e-3);
}

TEST(PixelKernel, APixelsHeightIsItsWidthByItsAspect) {
  const GlareTemplate t = soft_template(41, 41);
  const PixelKernel square = pixel_kernel(t, {1e-3, 1}, t.color_space);
  const PixelKernel flat = pixel_kernel(t, {1e-3, 2}, t.color_space);
  EXPECT_EQ(flat.width(), square.width());
  EXPECT_EQ(flat.height(), 83);  // 82 halves about a middle one: the outer two are half outside.
  const auto wide = spread(square.channels[0]), tall = spread(flat.channels[0]);
  EXPECT_NEAR(tall[0], wide[0], 1e-4);
  EXPECT_NEAR(tall[1], 4 * wide[1], 0.5);  // Less by up to 4/12: pixels of half the height.
  EXPECT_NEAR(sum(flat.channels[0]) / sum(square.channels[0]), 1, kSinglePrecision);
  EXPECT_EQ(flat.captured, square.captured);
}

TEST(PixelKernel, AnyNormalizationGivesTheSame) {
  TemplateOptions options = test::small_options();
  options.normalization = Normalization::absolute;
  const Spectrum lamp = *find_lamp("hid");
  const PixelScale scale{1e-4, 1};
  const auto kernel = [&] {
    return pixel_kernel(make_template(test::small_pupil(), lamp, options), scale,
                        options.color_space);
  };
  const PixelKernel absolute = kernel();
  for (const auto normalization : {Normalization::peak, Normalization::energy}) {
    options.normalization = normalization;
    const PixelKernel other = kernel();
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(other.captured[k], absolute.captured[k], kSinglePrecision);
      EXPECT_LT(test::difference(other.channels[k], absolute.channels[k]).relative, 3e-6);
    }
  }
}

TEST(PixelKernel, WhatIsBeyondTheReachIsCutButCounts) {
  const GlareTemplate t = soft_template(40, 30);
  const PixelScale scale{0.7e-3, 1.2};
  const PixelKernel whole = pixel_kernel(t, scale, t.color_space);
  PixelKernelOptions options;
  options.reach_x_px = 5;
  options.reach_y_px = 9;
  const PixelKernel cut = pixel_kernel(t, scale, t.color_space, options);
  ASSERT_EQ(cut.width(), 11);
  ASSERT_EQ(cut.height(), 19);
  EXPECT_EQ(cut.captured, whole.captured);
  const Image<float> middle =
      test::cropped(whole.channels[1], whole.width() / 2 - 5, whole.height() / 2 - 9, 11, 19);
  EXPECT_TRUE(std::ranges::equal(cut.channels[1].values(), middle.values()));
  options.reach_x_px = options.reach_y_px = 1000;
  EXPECT_EQ(pixel_kernel(t, scale, t.color_space, options).width(), whole.width());
}

TEST(PixelKernel, AMuchCoarserTemplateIsMadeAsFarAsItReaches) {
  const GlareTemplate t = soft_template(400, 400);
  PixelKernelOptions options;
  options.reach_x_px = options.reach_y_px = 50;
  // All of it would have 4e8 x 4e8 pixels.
  const PixelKernel kernel = pixel_kernel(t, {1e-9, 1}, t.color_space, options);
  EXPECT_EQ(kernel.width(), 101);
  EXPECT_THROW(pixel_kernel(t, {1e-9, 1}, t.color_space), OptionError);
}

TEST(PixelKernel, ScalesOfAPicture) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(scale_of_field_of_view(90, 1000).pitch_rad, kPi / 2000, 1e-15);
  EXPECT_NEAR(scale_of_perspective(90, 1000).pitch_rad, 2e-3, 1e-15);
  EXPECT_EQ(scale_of_perspective(90, 1000).pixel_aspect, 1);
  for (const auto scale : {scale_of_field_of_view, scale_of_perspective}) {
    for (const double fov_deg : {0., -1., 180.1, std::numeric_limits<double>::quiet_NaN()})
      EXPECT_THROW(scale(fov_deg, 100), OptionError) << fov_deg;
    EXPECT_THROW(scale(10, 0), OptionError);
  }
  EXPECT_THROW(scale_of_perspective(180, 100), OptionError);
  EXPECT_THROW(scale_of_field_of_view(100, 1), OptionError);
}

TEST(PixelKernel, RefusesWhatIsOutOfRange) {
  const GlareTemplate t = soft_template(5, 5);
  for (const double pitch : {0., -1e-3, 1.5, std::numeric_limits<double>::quiet_NaN()})
    test::expect_refused([&] { pixel_kernel(t, {pitch, 1}, t.color_space); }, "pitch");
  for (const double aspect : {0., 65., 1. / 65})
    test::expect_refused([&] { pixel_kernel(t, {1e-3, aspect}, t.color_space); }, "aspect");
  PixelKernelOptions options;
  options.shift_x_px = 0.6;
  test::expect_refused([&] { pixel_kernel(t, {1e-3, 1}, t.color_space, options); }, "shift");
  options = {};
  options.reach_y_px = -1;
  test::expect_refused([&] { pixel_kernel(t, {1e-3, 1}, t.color_space, options); }, "reach");
}

TEST(PixelKernel, RefusesATemplateWithoutLight) {
  const auto refuse = [](const auto& spoil) {
    GlareTemplate t = soft_template(5, 5);
    spoil(t);
    EXPECT_THROW(pixel_kernel(t, {1e-3, 1}, t.color_space), InputError);
  };
  refuse([](GlareTemplate& t) { t.channels.fill({}); });
  refuse([](GlareTemplate& t) { t.pixel_pitch_rad = 0; });
  refuse([](GlareTemplate& t) { t.per_steradian = 0; });
  refuse([](GlareTemplate& t) { t.light_xyz = {}; });
  refuse([](GlareTemplate& t) { t.light_xyz[2] = HUGE_VAL; });
  refuse([](GlareTemplate& t) { t.channels[1](2, 3) = std::nanf(""); });
  refuse([](GlareTemplate& t) { t.channels[2].row(0)[0] = HUGE_VALF; });
}

}  // namespace
}  // namespace glare
