#include "glare/picture/tone_mapping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glare/base/error.h"
#include "glare/color/tone_map.h"
#include "glare/picture/log_table.h"

namespace glare {
namespace {

using Rgb = std::array<float, 3>;

// What tone_mapped promises.
constexpr double kTolerance = 5e-5;

Picture picture_of(const std::vector<Rgb>& pixels) {
  Picture picture;
  picture.channels.fill(Image<float>(static_cast<int>(pixels.size()), 1));
  for (int x = 0; x < picture.width(); ++x)
    for (int k = 0; k < 3; ++k) picture.channels[k](x, 0) = pixels[static_cast<std::size_t>(x)][k];
  return picture;
}

Rgb mapped(const Rgb& pixel, const ToneMapping& mapping) {
  return tone_mapped(picture_of({pixel}), mapping)(0, 0);
}

Rgb grey(double value) {
  const auto v = static_cast<float>(value);
  return {v, v, v};
}

double srgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double sigmoid(double x, const ToneMapping& m) {
  const double p = std::pow(x, m.gamma);
  return std::min(1.0, m.display_maximum / 255 * (p + 1 / m.k) / (p + m.k));
}

void expect_near(const Rgb& actual, const Rgb& expected, double tolerance = kTolerance) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(actual[k], expected[k], tolerance) << "channel " << k;
}

ToneMapping code_values() {
  ToneMapping mapping;
  mapping.transfer = ToneMapping::Transfer::none;
  return mapping;
}

TEST(ToneMapping, SigmoidHasItsValuesByHand) {
  ToneMapping mapping = code_values();
  mapping.adaptation_luminance = 10;
  expect_near(mapped(grey(0), mapping), grey(1.0 / 256));          // D / k^2.
  expect_near(mapped(grey(10), mapping), grey(1.0 / 16));          // D / k.
  expect_near(mapped(grey(160), mapping), grey(257.0 / 512));      // x = k: (1 + 1/k^2) / 2.
  expect_near(mapped(grey(1440), mapping), grey(144.0625 / 160));  // x = 144.
  expect_near(mapped(grey(1e20), mapping), grey(1));
}

TEST(ToneMapping, SrgbEncodesTheLightThatTheDisplayEmits) {
  ToneMapping mapping;
  // 1.055 (1/16)^(1/2.4) - 0.055.
  expect_near(mapped(grey(1), mapping), grey(0.277308));
  mapping.display_maximum = 0.255;
  expect_near(mapped(grey(1), mapping), grey(12.92 / 16000));
}

TEST(ToneMapping, FollowsTheFormulaForAllSettings) {
  for (const double gamma : {0.1, 0.5, 1.0, 1.7, 4.0, 10.0})
    for (const double k : {1.0, 16.0, 300.0})
      for (const auto transfer : {ToneMapping::Transfer::srgb, ToneMapping::Transfer::none}) {
        ToneMapping mapping;
        mapping.gamma = gamma;
        mapping.k = k;
        mapping.display_maximum = 220;
        mapping.transfer = transfer;
        mapping.adaptation_luminance = 0.3;
        mapping.exposure_stops = 1.5;
        std::vector<Rgb> pixels;
        for (double x = 1e-7; x < 1e7; x *= 1.0137) pixels.push_back(grey(x));
        const auto result = tone_mapped(picture_of(pixels), mapping);
        double worst = 0;
        for (int i = 0; i < result.width(); ++i) {
          const double x = pixels[static_cast<std::size_t>(i)][0] * std::exp2(1.5) / 0.3;
          const double light = sigmoid(x, mapping);
          const double expected = transfer == ToneMapping::Transfer::srgb ? srgb(light) : light;
          worst = std::max(worst, std::abs(result(i, 0)[1] - expected));
        }
        EXPECT_LT(worst, kTolerance) << "gamma " << gamma << ", k " << k;
      }
}

TEST(ToneMapping, TableIsAsExactAsItSays) {
  const LogTable table(-20, 20, 7, [](double x) { return std::pow(x, 0.4); });
  double worst = 0;
  for (float x = 2e-6f; x < 5e5f; x *= 1.0003f)
    worst = std::max(worst, std::abs(table(x) / std::pow(static_cast<double>(x), 0.4) - 1));
  // 0.4 * 0.6 / (8 * 128^2), and the rounding of two floats.
  EXPECT_LT(worst, 1.9e-6 + 2e-7);
  EXPECT_EQ(table(0), table(std::ldexp(1.0f, -20)));
  EXPECT_EQ(table(-1), table(0));
  EXPECT_EQ(table(std::numeric_limits<float>::quiet_NaN()), table(0));
  EXPECT_NEAR(table(1e30f), 256, 1e-3);
}

TEST(ToneMapping, LuminanceKeepsTheChromaticity) {
  const Rgb color = {2, 3, 1};
  const double luminance = 0.2126 * 2 + 0.7152 * 3 + 0.0722;
  const ToneMapping mapping = code_values();
  const double factor = sigmoid(luminance, mapping) / luminance;
  expect_near(mapped(color, mapping), {static_cast<float>(2 * factor),
                                       static_cast<float>(3 * factor), static_cast<float>(factor)});
}

TEST(ToneMapping, PerChannelTurnsBrightColorsWhite) {
  ToneMapping mapping = code_values();
  mapping.application = ToneMapping::Application::per_channel;
  expect_near(mapped({16, 1, 0}, mapping), {257.0f / 512, 1.0f / 16, 1.0f / 256});
  expect_near(mapped({1e9f, 1e8f, 1e8f}, mapping), {1, 1, 1});
}

TEST(ToneMapping, NegativeChannelsMoveTowardsGreyBeforeTheirCurves) {
  ToneMapping mapping = code_values();
  mapping.application = ToneMapping::Application::per_channel;
  // Luminance 0.91336; 0.91336 / (0.91336 + 0.2) = 0.820364 of the colour is left.
  const double kept = 0.91336 + 0.820364 * (1 - 0.91336);
  const auto expected = static_cast<float>(sigmoid(kept, mapping));
  expect_near(mapped({1, 1, -0.2f}, mapping), {expected, expected, 1.0f / 256});
}

TEST(ToneMapping, WhatTheDisplayCannotShowMovesTowardsItsGrey) {
  ToneMapping mapping = code_values();
  mapping.curve = ToneMapping::Curve::linear;
  // Blue of luminance 0.5: 6.925 times as bright as its primary. Towards grey until blue is 1.
  const Rgb blue = mapped({0, 0, static_cast<float>(0.5 / 0.0722)}, mapping);
  EXPECT_NEAR(blue[2], 1, kTolerance);
  EXPECT_NEAR(blue[0], blue[1], kTolerance);
  EXPECT_NEAR(0.2126 * blue[0] + 0.7152 * blue[1] + 0.0722 * blue[2], 0.5, 2 * kTolerance);
  // A colour outside the display's triangle, luminance 0.6426: red is 0, luminance stays.
  const Rgb green = mapped({-0.35f, 1, 0.02f}, mapping);
  EXPECT_EQ(green[0], 0);
  EXPECT_NEAR(0.7152 * green[1] + 0.0722 * green[2], 0.7152 - 0.35 * 0.2126 + 0.02 * 0.0722,
              2 * kTolerance);
}

TEST(ToneMapping, LinearIsExposureAlone) {
  ToneMapping mapping = code_values();
  mapping.curve = ToneMapping::Curve::linear;
  mapping.exposure_stops = -2;
  mapping.adaptation_luminance = 77;
  expect_near(mapped({0.4f, 0.8f, 1.2f}, mapping), {0.1f, 0.2f, 0.3f});
  expect_near(mapped(grey(100), mapping), grey(1));
  expect_near(mapped(grey(-1), mapping), grey(0));
}

TEST(ToneMapping, ColorsAreBroughtToTheDisplaysPrimaries) {
  ToneMapping mapping = code_values();
  mapping.curve = ToneMapping::Curve::linear;
  Picture picture = picture_of({{0.95047f * 0.5f, 0.5f, 1.08883f * 0.5f}});
  picture.color_space = xyz_color_space();
  // D65 with five decimals, of BT.709's white with four.
  expect_near(tone_mapped(picture, mapping)(0, 0), grey(0.5), 2e-4);
}

TEST(ToneMapping, LightWithoutLuminanceIsTheDarkestGrey) {
  const ToneMapping mapping = code_values();
  for (const Rgb& pixel : {Rgb{0, 0, 0}, Rgb{-1, 0.1f, 0.1f}, Rgb{1e-42f, 1e-42f, 1e-42f}})
    expect_near(mapped(pixel, mapping), grey(1.0 / 256));
}

TEST(ToneMapping, NothingLeavesTheDisplaysRange) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Rgb> pixels;
  const float values[] = {0, 1e-45f, 1e-38f, -1e-38f, 1, -1, 3e38f, -3e38f, inf, -inf, nan};
  for (const float r : values)
    for (const float g : values)
      for (const float b : values) pixels.push_back({r, g, b});
  for (const auto curve : {ToneMapping::Curve::tumblin_sigmoid, ToneMapping::Curve::linear})
    for (const auto application :
         {ToneMapping::Application::luminance, ToneMapping::Application::per_channel}) {
      ToneMapping mapping;
      mapping.curve = curve;
      mapping.application = application;
      mapping.display_maximum = 400;
      const auto result = tone_mapped(picture_of(pixels), mapping);
      for (const Rgb& rgb : result.values())
        for (const float value : rgb) ASSERT_TRUE(value >= 0 && value <= 1) << value;
    }
}

TEST(ToneMapping, SameForAnyNumberOfThreads) {
  Picture picture;
  picture.channels.fill(Image<float>(37, 101));
  for (int k = 0; k < 3; ++k)
    for (int y = 0; y < 101; ++y)
      for (int x = 0; x < 37; ++x)
        picture.channels[k](x, y) = static_cast<float>((k * 7 + x * 13 + y * 29) % 101) - 5;
  const auto one = tone_mapped(picture, {}, 1);
  const auto two = tone_mapped(picture, {}, 2);
  EXPECT_TRUE(std::ranges::equal(one.values(), two.values()));
}

TEST(ToneMapping, RefusesSettingsOutsideTheirRanges) {
  const auto refused = [](auto change) {
    ToneMapping mapping;
    change(mapping);
    EXPECT_THROW(mapped(grey(1), mapping), OptionError);
  };
  refused([](ToneMapping& m) { m.adaptation_luminance = 0; });
  refused([](ToneMapping& m) { m.gamma = -1; });
  refused([](ToneMapping& m) { m.gamma = std::numeric_limits<double>::quiet_NaN(); });
  refused([](ToneMapping& m) { m.k = 0; });
  refused([](ToneMapping& m) { m.display_maximum = -3; });
  refused([](ToneMapping& m) { m.exposure_stops = 1e3; });
}

TEST(ToneMapping, EmptyPictureStaysEmpty) { EXPECT_TRUE(tone_mapped(Picture{}, {}).empty()); }

}  // namespace
}  // namespace glare
