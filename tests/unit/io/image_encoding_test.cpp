// PNG files that are made.
#include "glare/io/image_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "glare/base/error.h"
#include "support/image_file_fixture.h"

namespace glare::test {
namespace {

TEST_F(ImageFileTest, Gray16ComesBackAsItWas) {
  Image<float> image(3, 2);
  const Values values = {0, 1, 0.5f, 1 / 65535.f, 32768 / 65535.f, 0.123f};
  std::copy(values.begin(), values.end(), image.values().begin());
  const std::string file = text_of(encode_png_gray16(image));
  expect_near(values_from(file), values, 0.5f / 65535 + kRounding);  // Half a step of 16 bits.
  EXPECT_EQ(file, text_of(encode_png_gray16(image)));
  image(0, 0) = std::numeric_limits<float>::quiet_NaN();
  image(1, 0) = 7;
  image(2, 0) = -7;
  const Values limited = values_from(text_of(encode_png_gray16(image)));
  EXPECT_EQ(Values(limited.begin(), limited.begin() + 3), (Values{0, 1, 0}));
  EXPECT_THROW(encode_png_gray16({}), OutputError);
}

TEST_F(ImageFileTest, Rgb8KeepsMultiplesOfItsStep) {
  Image<std::array<float, 3>> image(256, 8);
  Values expected;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 256; ++x) {
      const float value = static_cast<float>(x) / 255;
      image(x, y) = {value, value, value};
      expected.push_back(value);
    }
  }
  const std::string file = text_of(encode_png_rgb8(image));
  expect_near(values_from(file), expected, kRounding);
  EXPECT_TRUE(contains(file, "sRGB"));
  EXPECT_FALSE(contains(file, "tIME"));
  EXPECT_EQ(file, text_of(encode_png_rgb8(image)));
  EXPECT_THROW(encode_png_rgb8({}), OutputError);
}

TEST_F(ImageFileTest, Rgb16IsRoundedAndTaggedSrgb) {
  Image<std::array<float, 3>> image(2, 1);
  image(0, 0) = {0.3f, 0.3f, 0.3f};
  image(1, 0) = {7, -7, std::numeric_limits<float>::quiet_NaN()};
  const std::string file = text_of(encode_png_rgb16(image));
  // 0.3 * 65535 = 19660.5, to the nearest of 1/65535.
  expect_near(values_from(file), {0.3f, 0.2126f}, 0.51f / 65535);
  EXPECT_TRUE(contains(file, "sRGB"));
  EXPECT_EQ(file, text_of(encode_png_rgb16(image)));
  EXPECT_THROW(encode_png_rgb16({}), OutputError);
}

TEST_F(ImageFileTest, Rgb8DitherKeepsTheMeanAndLimitsTheRest) {
  const float between = 100.25f / 255;
  Image<std::array<float, 3>> image(8, 8, {between, between, between});
  double sum = 0;
  for (const float value : values_from(text_of(encode_png_rgb8(image)))) sum += value;
  EXPECT_NEAR(sum / 64, between, 1e-6);  // 16 of the 64 thresholds let it through.
  const float nan = std::numeric_limits<float>::quiet_NaN();
  image = Image<std::array<float, 3>>(1, 1, {7, -7, nan});
  expect_near(values_from(text_of(encode_png_rgb8(image))), {0.2126f}, kRounding);
}

}  // namespace
}  // namespace glare::test
