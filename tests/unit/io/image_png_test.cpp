// PNG files, and what channels mean.
#include "glare/io/image_file.h"

#include <gtest/gtest.h>

#include "support/image_bytes.h"
#include "support/image_file_fixture.h"

namespace glare::test {
namespace {

using std::string_literals::operator""s;

TEST_F(ImageFileTest, PngValuesAreAsStored) {
  EXPECT_EQ(values_from(png({.pixels = "\0\0\xFF"s})), (Values{0, 1}));
  expect_near(values_from(png({.pixels = "\0\x80\x40"s})), {128 / 255.f, 64 / 255.f}, kRounding);
  expect_near(values_from(png({.bits = 16, .pixels = "\0\x80\0\xFF\xFF"s})), {32768 / 65535.f, 1},
              kRounding);
  EXPECT_EQ(values_from(png({.width = 3, .bits = 1, .pixels = "\0\xA0"s})), (Values{1, 0, 1}));
  const std::string gamma = png_chunk("gAMA", big(45455, 4)) + png_chunk("sRGB", "\0"s);
  expect_near(values_from(png({.pixels = "\0\x80\x40"s, .extra = gamma})),
              {128 / 255.f, 64 / 255.f}, kRounding);
}

TEST_F(ImageFileTest, ThreeChannelsGiveTheirLuminance) {
  const std::string pixels = "\0\xFF\0\0\0\xFF\0\0\0\xFF\xFF\xFF\xFF\x33\x33\x33"s;
  expect_near(values_from(png({.width = 5, .color_type = 2, .pixels = pixels})),
              {0.2126f, 0.7152f, 0.0722f, 1, 0.2f}, kRounding);
}

TEST_F(ImageFileTest, PalettesAreLookedUp) {
  const std::string palette = png_chunk("PLTE", "\0\0\0\xFF\xFF\xFF\0\xFF\0"s);
  const std::string pixels = "\0\2\1\0"s;
  expect_near(values_from(png({.width = 3, .color_type = 3, .pixels = pixels, .extra = palette})),
              {0.7152f, 1, 0}, kRounding);
  EXPECT_REFUSED(png({.width = 3, .color_type = 3, .pixels = pixels}), "has no palette");
}

TEST_F(ImageFileTest, AlphaIsIgnoredWithAWarning) {
  const TransmittanceImage image =
      image_from(png({.color_type = 4, .pixels = "\0\x33\x80\x66\x10"s}));
  expect_near({image.transmittance(0, 0), image.transmittance(1, 0)}, {0.2f, 0.4f}, kRounding);
  ASSERT_EQ(image.warnings.size(), 1u);
  EXPECT_TRUE(contains(image.warnings[0], "alpha"));
}

TEST_F(ImageFileTest, AlphaThatAloneVariesIsTheTransmittance) {
  const TransmittanceImage image =
      image_from(png({.color_type = 6, .pixels = "\0\x10\x20\x30\x33\x10\x20\x30\xFF"s}));
  expect_near({image.transmittance(0, 0), image.transmittance(1, 0)}, {0.2f, 1}, kRounding);
  EXPECT_TRUE(image.warnings.empty());
}

}  // namespace
}  // namespace glare::test
