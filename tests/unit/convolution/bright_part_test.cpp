#include "glare/convolution/bright_part.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "glare/base/error.h"
#include "support/every_target.h"
#include "support/refusals.h"

namespace glare {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();
using Rgb = std::array<float, 3>;

Picture picture_of(const std::vector<Rgb>& pixels) {
  Picture picture;
  picture.channels.fill(Image<float>(static_cast<int>(pixels.size()), 1));
  for (int x = 0; x < picture.width(); ++x)
    for (std::size_t k = 0; k < 3; ++k)
      picture.channels[k](x, 0) = pixels[static_cast<std::size_t>(x)][k];
  return picture;
}

Rgb light_of(const Rgb& pixel, const BrightPartOptions& options) {
  Picture bright;
  bright_part(picture_of({pixel}), options, bright);
  return {bright.channels[0](0, 0), bright.channels[1](0, 0), bright.channels[2](0, 0)};
}

double light_of_grey(double value, const BrightPartOptions& options) {
  const auto v = static_cast<float>(value);
  return static_cast<double>(light_of({v, v, v}, options)[1]);
}

class BrightPart : public test::EveryTarget {};
INSTANTIATE_TEST_SUITE_P(EveryTarget, BrightPart, test::every_target(), test::target_name);

TEST_P(BrightPart, IsAllTheExposedLightByDefault) {
  EXPECT_EQ(light_of({0.25f, 3, 1e30f}, {}), (Rgb{0.25f, 3, 1e30f}));
  EXPECT_EQ(light_of({0.25f, 3, 1e30f}, {.exposure_stops = 3}), (Rgb{2, 24, 8e30f}));
}

TEST_P(BrightPart, HasASoftKnee) {
  const BrightPartOptions options{.threshold = 4, .knee = 0.5};  // From 2 to 6.
  // White is luminance 1 to a few roundings.
  EXPECT_EQ(light_of_grey(1.999, options), 0);
  EXPECT_NEAR(light_of_grey(4, options), 0.5, 2e-6);  // (4 - 2)^2 / (4 0.5 4).
  EXPECT_NEAR(light_of_grey(6, options), 2, 2e-6);
  EXPECT_NEAR(light_of_grey(100, options), 96, 2e-5);
  // Value and slope go on at both ends: the parabola's curvature is 1 / (2 knee threshold).
  for (const double end : {2.0, 6.0}) {
    constexpr double h = 0.01;
    const double change = light_of_grey(end + h, options) - 2 * light_of_grey(end, options) +
                          light_of_grey(end - h, options);
    EXPECT_NEAR(change, h * h / 8, 3e-6) << end;  // Half the curvature, since it begins or ends.
  }
}

TEST_P(BrightPart, CanBeHard) {
  const BrightPartOptions options{.threshold = 4, .knee = 0};
  EXPECT_EQ(light_of_grey(3.999, options), 0);
  EXPECT_NEAR(light_of_grey(4.5, options), 0.5, 2e-6);
  const BrightPartOptions softest{.threshold = 4, .knee = 1};
  EXPECT_NEAR(light_of_grey(1, softest), 1.0 / 16, 1e-6);  // 1^2 / (4 4).
}

TEST_P(BrightPart, KeepsTheColour) {
  const Rgb light = light_of({1, 8, 2}, {.threshold = 3});
  EXPECT_NEAR(light[1] / light[0], 8, 1e-5);
  EXPECT_NEAR(light[2] / light[0], 2, 1e-6);
  Picture xyz = picture_of({{1, 8, 2}}), bright;
  xyz.color_space = xyz_color_space();
  bright_part(xyz, {.threshold = 3}, bright);
  EXPECT_NEAR(bright.channels[1](0, 0), 5, 2e-6);  // Y itself.
  EXPECT_NEAR(bright.channels[0](0, 0), 5. / 8, 1e-6);
  EXPECT_TRUE(bright.color_space.is_xyz());
}

TEST_P(BrightPart, ThresholdIsOfTheExposedPicture) {
  EXPECT_NEAR(light_of_grey(2, {.exposure_stops = 2, .threshold = 4}), 4, 2e-6);
}

TEST_P(BrightPart, UnusablePixelsGiveNone) {
  for (const double threshold : {0.0, 0.01}) {
    Picture bright;
    // Twenty pixels, so that some are beyond whole vectors.
    std::vector<Rgb> pixels(20, Rgb{1, 1, 1});
    pixels[0] = {kNan, 1, 1};
    pixels[1] = {1, kInfinity, kNan};
    pixels[2] = {1, 1, -kInfinity};
    pixels[3] = {-1, kInfinity, 1};
    pixels[17] = {1, -1, -2};
    pixels[18] = {-0.0f, 0, 0};
    pixels[19] = {kLargest, kLargest, kLargest};
    const UnusablePixels found = bright_part(picture_of(pixels), {.threshold = threshold}, bright);
    EXPECT_EQ(found.nan, 2);
    EXPECT_EQ(found.infinite, 2);
    EXPECT_EQ(found.negative, 1);
    EXPECT_EQ(found.total(), 5);
    for (std::size_t k = 0; k < 3; ++k) {
      for (int x = 0; x < 4; ++x) EXPECT_EQ(bright.channels[k](x, 0), 0);
      EXPECT_EQ(bright.channels[k](18, 0), 0);
      EXPECT_GT(bright.channels[k](19, 0), kLargest / 4);
      EXPECT_LE(bright.channels[k](19, 0), kLargest);
    }
    EXPECT_GT(bright.channels[0](17, 0), 0);
    EXPECT_EQ(bright.channels[1](17, 0), 0);
  }
  // The exposure can make a value infinite.
  Picture bright;
  EXPECT_EQ(bright_part(picture_of({{1e38f, 0, 0}}), {.exposure_stops = 4}, bright).infinite, 1);
}

TEST_P(BrightPart, MayTakeItsOwnPlace) {
  Picture picture = picture_of({{1, 2, 3}, {4, 5, 6}});
  bright_part(picture, {.exposure_stops = 1}, picture);
  EXPECT_EQ(picture.channels[2](1, 0), 12);
}

TEST(BrightPartOptions, OutOfRangeAreRefused) {
  Picture picture = picture_of({{1, 1, 1}}), bright;
  const auto refused = [&](const BrightPartOptions& options, const std::string& name) {
    test::expect_refused([&] { bright_part(picture, options, bright); }, name);
  };
  refused({.exposure_stops = 65}, "exposure");
  refused({.threshold = -1}, "threshold");
  refused({.threshold = kNan}, "threshold");
  refused({.threshold = 1, .knee = 1.5}, "knee");
}

}  // namespace
}  // namespace glare
