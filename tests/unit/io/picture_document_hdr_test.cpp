// Radiance pictures, and from one kind of file to the other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "support/image_bytes.h"
#include "support/picture_document_fixture.h"

namespace glare::test {
namespace {

using std::string_literals::operator""s;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kLines =
    "#?RADIANCE\n# a comment\nEXPOSURE=2.5\nVIEW= -vtv -vp 0 1 0 -vh 60 -vv 40\nPIXASPECT=0.5\n"
    "PRIMARIES=0.64 0.33 0.21 0.71 0.15 0.06 0.3127 0.329\n";
const std::string kPixels = "\x80\x40\x20\x82\xFF\x01\x10\x60"s;

std::string radiance(const std::string& lines = kLines, const std::string& kind = "rgbe",
                     const std::string& size = "-Y 1 +X 2") {
  return lines + "FORMAT=32-bit_rle_" + kind + "\n\n" + size + "\n" + kPixels;
}

TEST_F(PictureDocumentTest, RadianceStaysTheSameFile) {
  const PictureDocument picture = document(radiance());
  EXPECT_EQ(written(picture, 1, "out.hdr"), radiance());
  EXPECT_THAT(picture.warnings(), IsEmpty());
  EXPECT_EQ(picture.pixel_aspect(), 2);
  EXPECT_NEAR(picture.picture().color_space.primaries()[1].y, 0.71, 1e-9);
  // 128 / 256 * 2^(130 - 128); some decoders take a step's middle.
  expect_near(pixel(picture.picture(), 0, 0), {2, 1, 0.5f}, 0.01f);
}

TEST_F(PictureDocumentTest, RadianceOfXyz) {
  const PictureDocument picture = document(radiance("#?RADIANCE\n", "xyze"));
  EXPECT_TRUE(picture.picture().color_space.is_xyz());
  EXPECT_EQ(written(picture, 1, "out.hdr"), radiance("#?RADIANCE\n", "xyze"));
}

TEST_F(PictureDocumentTest, RadianceTellsItsAngle) {
  const auto pitch = document(radiance()).pixel_pitch();
  ASSERT_TRUE(pitch);
  EXPECT_NEAR(pitch->pitch_rad, 2 * std::tan(std::numbers::pi / 6) / 2, 1e-12);
  EXPECT_EQ(pitch->source, "VIEW (-vh)");
  for (const char* none : {"VIEW= -vth -vh 180\n", "VIEW= -vp 0 0 0\n", "VIEW= -vh x\n", ""})
    EXPECT_FALSE(document(radiance("#?RADIANCE\n"s + none)).pixel_pitch()) << none;
}

TEST_F(PictureDocumentTest, RunsOfEqualBytes) {
  const int width = 300;
  Values rows(3 * width, 0.25f);
  for (int x = 100; x < 120; ++x)
    rows[static_cast<std::size_t>(x)] = 1.0f + 0.0625f * static_cast<float>(x % 7);
  const PictureDocument picture = document(
      exr({.channels = {"B", "G", "R"}, .width = width, .full_width = width, .rows = rows}));
  EXPECT_LT(written(picture, 1, "out.hdr").size(), 350u);
  const Picture back = read(folder_ / "out.hdr").picture();
  for (int x = 0; x < width; ++x)
    for (int k = 0; k < 3; ++k)  // A step of the largest channel's exponent.
      EXPECT_NEAR(back.channels[k](x, 0), picture.picture().channels[k](x, 0), 2.0f / 256) << x;
}

TEST_F(PictureDocumentTest, ValuesThatRadianceCannotHoldAreCounted) {
  const PictureDocument document = this->document(radiance());
  Picture changed = document.picture();
  changed.channels[0](0, 0) = -1;
  changed.channels[1](0, 0) = 0.5f;
  changed.channels[2](0, 0) = std::nanf("");
  changed.channels[0](1, 0) = std::numeric_limits<float>::infinity();
  EXPECT_EQ(document.write(folder_ / "out.hdr", changed), 2u);
  const Picture back = read(folder_ / "out.hdr").picture();
  EXPECT_NEAR(back.channels[0](0, 0), 0, 0.01);
  EXPECT_NEAR(back.channels[1](0, 0), 0.5, 0.01);
  EXPECT_NEAR(back.channels[2](0, 0), 0, 0.01);
  EXPECT_GT(back.channels[0](1, 0), 1e38f);
}

TEST_F(PictureDocumentTest, FromOneKindToTheOther) {
  const PictureDocument first = document(radiance());
  EXPECT_THAT(first.losses("x.exr"), ElementsAre(HasSubstr("header")));
  EXPECT_THAT(first.losses("x.hdr"), IsEmpty());
  written(first);
  const PictureDocument open_exr = read(folder_ / "out.exr");
  EXPECT_EQ(open_exr.pixel_aspect(), 2);
  EXPECT_EQ(pixel(open_exr.picture(), 1, 0), pixel(first.picture(), 1, 0));
  EXPECT_NEAR(open_exr.picture().color_space.primaries()[1].y, 0.71, 1e-6);
  EXPECT_THAT(open_exr.losses("x.HDR"), ElementsAre(HasSubstr("colours only")));
  const std::string back = written(open_exr, 1, "back.hdr");
  EXPECT_THAT(back, HasSubstr("PRIMARIES=0.64 0.33 0.21 0.71 0.15 0.06 0.3127 0.329\n"));
  EXPECT_THAT(back, HasSubstr("PIXASPECT=0.5\n"));
  EXPECT_TRUE(back.ends_with(kPixels));
  const PictureDocument gray = read(fixture("kept_rows.exr"), 0, "Z");
  Picture changed = gray.picture();
  changed.channels[1](0, 0) = 1000;  // Not looked at.
  gray.write(folder_ / "gray.hdr", changed);
  const Values first_pixel = pixel(read(folder_ / "gray.hdr").picture(), 0, 0);
  EXPECT_EQ(first_pixel[0], first_pixel[1]);
}

TEST_F(PictureDocumentTest, RefusesOtherOrdersAndDamage) {
  EXPECT_THAT(refused(radiance(kLines, "rgbe", "+X 2 -Y 1")), HasSubstr("order other than -Y +X"));
  EXPECT_THAT(refused(radiance(kLines, "rgbe", "+Y 1 +X 2")), HasSubstr("order other than -Y +X"));
  EXPECT_THAT(refused(radiance(kLines, "abcd")), HasSubstr("32-bit_rle_rgbe"));
  EXPECT_THAT(refused(radiance("#?RADIANCE\nPIXASPECT=0\n")), HasSubstr("PIXASPECT"));
  EXPECT_THAT(refused(radiance("#?RADIANCE\nPRIMARIES=1 2\n")), HasSubstr("PRIMARIES"));
  EXPECT_THAT(refused(radiance(), 1), HasSubstr("only OpenEXR files"));
  const std::string whole = radiance();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refused(whole.substr(0, size)), "nothing was refused") << size;
}

TEST_F(PictureDocumentTest, OrdinaryPicturesAreReadWithAWarning) {
  const PictureDocument picture =
      document(png({.width = 1, .bits = 8, .color_type = 2, .pixels = "\0\xBC\x0A\xFF"s}));
  EXPECT_THAT(picture.warnings(), ElementsAre(HasSubstr("sRGB curve")));
  expect_near(pixel(picture.picture(), 0, 0), {0.502886f, 0.00303527f, 1}, kRounding);
  written(picture);
  EXPECT_EQ(pixel(read(folder_ / "out.exr").picture(), 0, 0), pixel(picture.picture(), 0, 0));
}

}  // namespace
}  // namespace glare::test
