#include "glare/aperture/aperture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "glare/base/error.h"

namespace glare {
namespace {

Aperture open_aperture(int width, int height, double width_mm, float t = 1) {
  return {Image<float>(width, height, t), width_mm};
}

/// Waves of `cycles` across the width and half as many down, between 0.1 and 0.9.
Image<float> waves(int width, int height, double cycles) {
  Image<float> image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width, v = (y + 0.5) / height;
      const double phase = 2 * std::numbers::pi * cycles;
      image(x, y) = static_cast<float>(0.5 + 0.4 * std::cos(phase * u) * std::cos(phase * v / 2));
    }
  return image;
}

void expect_refused(const Aperture& aperture, const std::string& part_of_message) {
  try {
    require_valid(aperture);
    ADD_FAILURE() << "accepted, expected: " << part_of_message;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(part_of_message), std::string::npos) << error.what();
  }
}

TEST(Aperture, PixelIsTheSameBothWays) {
  const Aperture aperture = open_aperture(8, 4, 2);
  EXPECT_DOUBLE_EQ(aperture.pixel_mm(), 0.25);
  EXPECT_DOUBLE_EQ(aperture.height_mm(), 1);
}

TEST(Aperture, EnergyAreaIsTheIntegralOfTheSquare) {
  EXPECT_DOUBLE_EQ(energy_area_mm2(open_aperture(8, 4, 2)), 2);
  EXPECT_DOUBLE_EQ(energy_area_mm2(open_aperture(8, 4, 2, 0.5f)), 0.5);
}

TEST(Aperture, EnergyAreaDoesNotLoseSmallTerms) {
  // A float sum would stop growing at 2^24 samples.
  EXPECT_DOUBLE_EQ(energy_area_mm2(open_aperture(5000, 4000, 5)), 20);
}

TEST(RequireValid, AcceptsOpenAndGrey) {
  EXPECT_NO_THROW(require_valid(open_aperture(2, 2, 1)));
  EXPECT_NO_THROW(require_valid(open_aperture(3, 2, 1e-3, 0.1f)));
}

TEST(RequireValid, NamesWhatIsWrong) {
  expect_refused(open_aperture(1, 8, 1), "1 x 8 pixels");
  expect_refused(open_aperture(8, 1, 1), "8 x 1 pixels");
  expect_refused({}, "0 x 0 pixels");
  for (const double width_mm : {0.0, -1.0, std::nan(""), HUGE_VAL})
    expect_refused(open_aperture(4, 4, width_mm), "mm wide");
  expect_refused(open_aperture(4, 4, 1, 0), "opaque");
}

TEST(RequireValid, SaysWhichPixel) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {-0.001f, 1.001f, std::nanf(""), infinity, -infinity}) {
    Aperture aperture = open_aperture(4, 3, 1);
    aperture.transmittance(2, 1) = bad;
    expect_refused(aperture, "pixel (2, 1)");
  }
}

TEST(Stacked, MultipliesEqualGridsExactly) {
  Aperture front = open_aperture(3, 2, 1, 0.5f);
  front.transmittance(1, 0) = 0;
  const Aperture both = stacked(front, open_aperture(3, 2, 1, 0.25f));
  EXPECT_EQ(both.width_mm, 1);
  EXPECT_EQ(both.transmittance(1, 0), 0);
  EXPECT_EQ(both.transmittance(0, 0), 0.125f);
  EXPECT_EQ(both.transmittance(2, 1), 0.125f);
}

TEST(Stacked, TakesTheFinerGridInEitherOrder) {
  const Aperture fine{waves(96, 64, 3), 6};
  const Aperture coarse = open_aperture(24, 16, 6, 0.5f);
  for (const Aperture& both : {stacked(fine, coarse), stacked(coarse, fine)}) {
    ASSERT_EQ(both.transmittance.width(), 96);
    ASSERT_EQ(both.transmittance.height(), 64);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 96; ++x)
        EXPECT_FLOAT_EQ(both.transmittance(x, y), 0.5f * fine.transmittance(x, y));
  }
}

TEST(Stacked, AcceptsHeightsThatDifferByRoundingOnly) {
  // 1000 x 333 brought to a width of 100 is 100 x 33.3.
  const Aperture fine = open_aperture(1000, 333, 5);
  EXPECT_NO_THROW(stacked(fine, open_aperture(100, 33, 5)));
  EXPECT_NO_THROW(stacked(open_aperture(100, 33, 5), fine));
  EXPECT_THROW(stacked(fine, open_aperture(100, 34, 5)), InputError);
  EXPECT_THROW(stacked(open_aperture(100, 34, 5), fine), InputError);
  EXPECT_THROW(stacked(open_aperture(100, 34, 5), open_aperture(100, 33, 5)), InputError);
}

TEST(Stacked, RefusesDifferentWidths) {
  EXPECT_THROW(stacked(open_aperture(8, 8, 6), open_aperture(8, 8, 6.1)), InputError);
  EXPECT_THROW(stacked(open_aperture(8, 8, 6), open_aperture(8, 8, std::nan(""))), InputError);
  EXPECT_NO_THROW(stacked(open_aperture(8, 8, 6), open_aperture(8, 8, 6.0000001)));
}

TEST(Enlarged, SameSizeIsTheSamePicture) {
  const Image<float> image = waves(12, 7, 2);
  EXPECT_TRUE(std::ranges::equal(enlarged(image, 12, 7).values(), image.values()));
}

TEST(Enlarged, KeepsAConstant) {
  const Image<float> result = enlarged(Image<float>(5, 3, 0.7f), 17, 11);
  for (const float t : result.values()) EXPECT_FLOAT_EQ(t, 0.7f);
}

TEST(Enlarged, FollowsAWaveOverTheSameRectangle) {
  const Image<float> result = enlarged(waves(64, 48, 4), 150, 101);
  const Image<float> expected = waves(150, 101, 4);
  // 16 samples a cycle: Lanczos' kernel of 8 taps is within 0.3 % of the amplitude there. The
  // outermost 4 old samples (10 new ones) are left out: beyond the edge the wave doesn't go on.
  for (int y = 10; y < 91; ++y)
    for (int x = 10; x < 140; ++x)
      ASSERT_NEAR(result(x, y), expected(x, y), 0.002) << x << ", " << y;
}

TEST(Enlarged, OddFactorKeepsTheOldSamples) {
  // With a factor of 3, every third new centre is an old centre.
  const Image<float> image = waves(20, 16, 5);
  const Image<float> result = enlarged(image, 60, 48);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 20; ++x)
      EXPECT_NEAR(result(3 * x + 1, 3 * y + 1), image(x, y), 1e-6);  // float rounding
}

TEST(Enlarged, StaysWithinZeroAndOneAtAStep) {
  Image<float> step(16, 16, 0);
  for (int y = 0; y < 16; ++y)
    for (int x = 8; x < 16; ++x) step(x, y) = 1;
  const Image<float> result = enlarged(step, 64, 64);
  EXPECT_TRUE(std::ranges::all_of(result.values(), [](float t) { return t >= 0 && t <= 1; }));
  EXPECT_EQ(result(0, 30), 0);
  EXPECT_EQ(result(63, 30), 1);
  for (int x = 0; x < 32; ++x)  // the step stays in the middle
    EXPECT_NEAR(result(x, 30) + result(63 - x, 30), 1, 1e-6);
}

}  // namespace
}  // namespace glare
