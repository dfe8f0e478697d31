// PNM, BMP and Radiance HDR files.
#include "glare/io/image_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>

#include "support/image_bytes.h"
#include "support/image_file_fixture.h"

namespace glare::test {
namespace {

using std::string_literals::operator""s;

TEST_F(ImageFileTest, ReadsPnm) {
  EXPECT_EQ(values_from("P1 3 1 101"), (Values{0, 1, 0}));
  EXPECT_EQ(values_from("P1\n3 1\n1 0\n1\n"), (Values{0, 1, 0}));
  EXPECT_EQ(values_from("P4 3 1\n\xA0"), (Values{0, 1, 0}));
  EXPECT_EQ(values_from("P2 3 1 4 1 4 0"), (Values{0.25f, 1, 0}));
  EXPECT_EQ(values_from("P5 1 2 65535\n\xFF\xFF\0\0"s), (Values{1, 0}));
  EXPECT_EQ(values_from("P5\n# a comment\n2 1 255\n\0\xFF"s), (Values{0, 1}));
  expect_near(values_from("P5 2 1 1023\n\x03\xFF\x02\x00"s), {1, 512 / 1023.f}, kRounding);
  expect_near(values_from("P5 2 1 100\n\x64\x32"), {1, 0.5f}, kRounding);
  expect_near(values_from("P6 1 1 255\n\0\xFF\0"s), {0.7152f}, kRounding);
  // The last row comes first; of the third number, only the sign counts.
  EXPECT_EQ(values_from("Pf\n1 2\n-3.5\n" + floats({0.25f, 0.75f})), (Values{0.75f, 0.25f}));
  EXPECT_EQ(values_from("Pf 1 1 1.0\n" + big(std::bit_cast<std::uint32_t>(0.5f), 4)),
            (Values{0.5f}));
}

TEST_F(ImageFileTest, RefusesBadPnm) {
  for (const std::string start : {"P5 -3 4 255\n", "P5 3 4 0\n", "P5 3 4 65536\n", "P5 0 4 255\n",
                                  "P5 x 4 255\n", "P5 3 4", "Pf 1 1 nan\n", "Pf 1 1 0\n"}) {
    EXPECT_NE(refusal(start + std::string(64, '\0')), "") << start;
  }
  EXPECT_REFUSED("P5 2000000000 2000000000 255\n", "2000000000 x 2000000000");
  EXPECT_REFUSED("P5 4 4 255\nabc", "cut short");
  EXPECT_REFUSED("P5 2 1 100\n\x65\x32", "above its maximum");
  EXPECT_REFUSED("P2 2 1 100\n1 101", "above its maximum");
  EXPECT_REFUSED("P1 3 1 12x", "0 and 1");
}

TEST_F(ImageFileTest, ReadsBmp) {
  // Rows are stored from the bottom, each filled to 4 bytes.
  const std::string rows = "\x33\x33\x33\0"s + "\xFF\xFF\xFF\0"s;
  expect_near(values_from(bmp(1, 2, 24, "", rows)), {1, 0.2f}, kRounding);
  expect_near(values_from(bmp(1, -2, 24, "", rows)), {0.2f, 1}, kRounding);
  const std::string palette = "\0\0\0\0\xFF\xFF\xFF\0"s;
  EXPECT_EQ(values_from(bmp(3, 1, 1, palette, "\xA0\0\0\0"s)), (Values{1, 0, 1}));
  expect_near(values_from(bmp(2, 1, 8, palette, "\1\0\0\0"s)), {1, 0}, kRounding);
  expect_near(values_from(bmp(1, 1, 24, "", "\xFF\0\0\0"s)), {0.0722f}, kRounding);  // Blue first.
}

TEST_F(ImageFileTest, RefusesBadBmp) {
  EXPECT_REFUSED(bmp(1000, 1000, 24, "", "abcd"), "cut short");
  EXPECT_NE(refusal(bmp(-1, 1, 24, "", "abcd")), "");
  EXPECT_NE(refusal(bmp(1, std::numeric_limits<int>::min(), 24, "", "abcd")), "");
  EXPECT_NE(refusal(bmp(1, 1, 17, "", "abcd")), "");
}

TEST_F(ImageFileTest, ReadsRadianceHdr) {
  // Exponent 128 and mantissa m: m / 256, or (m + 0.5) / 256 to some decoders.
  expect_near(values_from(hdr("-Y 1 +X 2", "\x80\x80\x80\x80\x40\x40\x40\x80")), {0.5f, 0.25f},
              0.002f);
  const std::string row = "\x02\x02\x00\x08"s + "\x88\x80\x88\x80\x88\x80\x88\x80"s;
  expect_near(values_from(hdr("-Y 1 +X 8", row)), Values(8, 0.5f), 0.002f);
}

TEST_F(ImageFileTest, RefusesBadRadianceHdr) {
  for (const std::string size :
       {"-Y 2147483647 +X 2147483647", "-Y -5 +X 5", "-Y 5 +X -5", "-Y 1 +X 99999999999999999999",
        "-Y 0 +X 0", "+X 4 +Y 4", "-Y 2 +X 40000", "-Y", "-Y  +X ", "", "-Y 3 +X 8"}) {
    EXPECT_NE(refusal(hdr(size, "abcd")), "") << size;
  }
  EXPECT_REFUSED("#?RGBE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd", "32-bit_rle_rgbe");
}

}  // namespace
}  // namespace glare::test
