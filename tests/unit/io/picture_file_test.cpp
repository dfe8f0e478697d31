#include "glare/io/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "glare/base/error.h"
#include "glare/io/color_config.h"
#include "glare/io/picture_document.h"
#include "glare/io/template_file.h"
#include "support/image_bytes.h"
#include "support/image_file_fixture.h"
#include "support/templates.h"

namespace glare::test {
namespace {

using std::string_literals::operator""s;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PictureFileTest : public ImageFileTest {
 protected:
  PictureFile read(const std::string& content) const { return read_picture(put(content), kMemory); }

  std::string message_of(const std::string& content) const {
    try {
      read(content);
    } catch (const InputError& error) {
      return error.message();
    }
    return "nothing was refused";
  }
};

Values pixel(const PictureFile& file, int x, int y) {
  const auto& c = file.picture.channels;
  return {c[0](x, y), c[1](x, y), c[2](x, y)};
}

Picture sample(const RgbColorSpace& space) {
  Picture picture;
  for (int k = 0; k < 3; ++k)
    picture.channels[k] =
        test::picture(19, 11, [&](int x, int y) { return std::exp(0.7 * x - y) - 2 * k; });
  picture.color_space = space;
  return picture;
}

void expect_same_pixels(const Picture& a, const Picture& b) {
  for (int k = 0; k < 3; ++k)
    EXPECT_TRUE(std::ranges::equal(a.channels[k].values(), b.channels[k].values())) << k;
}

std::string chromaticities(const Values& numbers) {
  return attribute("chromaticities", "chromaticities", floats(numbers));
}

constexpr auto kRgb = [](const std::string& extra) {
  return exr({.channels = {"B", "G", "R"}, .rows = {1, 2, 3, 4, 5, 6}, .extra = extra});
};

TEST_F(PictureFileTest, WritesWhatItReads) {
  for (const char* name : {"lin_rec709", "acescg", "lin_rec2020", "xyz"}) {
    const Picture picture = sample(find_color_space(name));
    write_picture(folder_ / "a.exr", picture);
    const PictureFile back = read_picture(folder_ / "a.exr", kMemory);
    expect_same_pixels(back.picture, picture);
    EXPECT_EQ(back.picture.color_space.name(), name);
    EXPECT_EQ(back.picture.color_space.rgb_from_xyz(), picture.color_space.rgb_from_xyz());
    EXPECT_FALSE(back.was_display_encoded);
    EXPECT_THAT(back.warnings, IsEmpty());
  }
}

TEST_F(PictureFileTest, SameBytesForTheSamePicture) {
  const Picture picture = sample(lin_rec709_color_space());
  PictureFileOptions two;
  two.threads = 2;
  write_picture(folder_ / "a.exr", picture);
  write_picture(folder_ / "b.exr", picture, two);
  EXPECT_EQ(content_of(folder_ / "a.exr"), content_of(folder_ / "b.exr"));
}

TEST_F(PictureFileTest, AttributesAreWritten) {
  PictureFileOptions options;
  options.attributes = {{"glare:scene", "a = 1"}};
  write_picture(folder_ / "a.exr", sample(lin_rec709_color_space()), options);
  bool found = false;
  for (const HeaderAttribute& a : read_header(folder_ / "a.exr"))
    found = found || (a.name == "glare:scene" && a.type == "string" && a.value == "a = 1");
  EXPECT_TRUE(found);
}

TEST_F(PictureFileTest, ALayerMayHaveAlpha) {
  const Picture picture = sample(lin_rec709_color_space());
  const Image<float> alpha = picture.channels[1], small(3, 3);
  const PictureLayer layer = {"", &picture, &alpha}, wrong = {"", &picture, &small};
  write_picture_layers(folder_ / "a.exr", {&layer, 1});
  const PictureFile back = read_picture(folder_ / "a.exr", kMemory);
  expect_same_pixels(back.picture, picture);
  EXPECT_THAT(back.warnings, ElementsAre("the alpha channel is ignored"));
  EXPECT_THROW(write_picture_layers(folder_ / "b.exr", {&wrong, 1}), OptionError);
}

TEST_F(PictureFileTest, HalfRoundsOrIsRefused) {
  PictureFileOptions half;
  half.half = true;
  Picture picture = sample(lin_rec709_color_space());
  EXPECT_THROW(write_picture(folder_ / "a.exr", picture, half), OptionError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.exr"));
  for (auto& channel : picture.channels)
    for (float& value : channel.values()) value = std::min(value, 60000.0f);
  write_picture(folder_ / "a.exr", picture, half);
  const PictureFile back = read_picture(folder_ / "a.exr", kMemory);
  for (int y = 0; y < 11; ++y)
    for (int x = 0; x < 19; ++x)  // Of 11 bits.
      EXPECT_NEAR(back.picture.channels[1](x, y), picture.channels[1](x, y),
                  1e-7 + std::abs(picture.channels[1](x, y)) / 2048);
}

TEST_F(PictureFileTest, LayersHaveChannelsOfTheirOwn) {
  const Picture beauty = sample(lin_rec709_color_space());
  Picture glare = beauty;
  for (auto& channel : glare.channels)
    for (float& value : channel.values()) value = 0.125f - value;
  const std::vector<PictureLayer> layers = {{"", &beauty}, {"glare", &glare}};
  write_picture_layers(folder_ / "a.exr", layers);
  const auto layer = [&](const char* name) {
    return PictureDocument::read(folder_ / "a.exr", {-1, name, kMemory}).picture();
  };
  expect_same_pixels(layer(""), beauty);
  expect_same_pixels(layer("glare"), glare);
  std::vector<std::string> channels;
  for (const HeaderAttribute& a : read_header(folder_ / "a.exr"))
    if (a.name.starts_with("channel ")) channels.push_back(a.name.substr(8));
  EXPECT_THAT(channels, ElementsAre("B", "G", "R", "glare.B", "glare.G", "glare.R"));
}

TEST_F(PictureFileTest, LayersInHalf) {
  const Picture one = [] {
    Picture p = sample(lin_rec709_color_space());
    for (auto& channel : p.channels)
      for (float& value : channel.values()) value = std::round(std::min(value, 60.0f));
    return p;
  }();
  Picture two = one;
  two.channels[2](18, 10) = -2048;
  PictureFileOptions half;
  half.half = true;
  write_picture_layers(folder_ / "a.exr", std::vector<PictureLayer>{{"x", &one}, {"y.z", &two}},
                       half);
  expect_same_pixels(PictureDocument::read(folder_ / "a.exr", {-1, "y.z", kMemory}).picture(), two);
  expect_same_pixels(PictureDocument::read(folder_ / "a.exr", {-1, "x", kMemory}).picture(), one);
}

TEST_F(PictureFileTest, RefusesLayersThatDoNotGoTogether) {
  const Picture one = sample(lin_rec709_color_space());
  Picture larger = one, other = one;
  larger.channels.fill(Image<float>(20, 11));
  other.color_space = find_color_space("acescg");
  const auto write = [&](const std::vector<PictureLayer>& layers) {
    write_picture_layers(folder_ / "a.exr", layers);
  };
  EXPECT_THROW(write({{"", &one}, {"b", &larger}}), OptionError);
  EXPECT_THROW(write({{"", &one}, {"b", &other}}), OptionError);
  EXPECT_THROW(write({{"b", &one}, {"b", &one}}), OptionError);
  for (const char* name : {".", "a.", ".a", "a..b"})
    EXPECT_THROW(write({{name, &one}}), OptionError) << name;
  EXPECT_THROW(write({}), OutputError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.exr"));
}

TEST_F(PictureFileTest, RefusesToWriteNothingOrNowhere) {
  EXPECT_THROW(write_picture(folder_ / "a.exr", Picture{}), OutputError);
  EXPECT_THROW(write_picture(folder_ / "no" / "a.exr", sample(xyz_color_space())), OutputError);
  PictureFileOptions stopped;
  stopped.keep_going = [] { return false; };
  EXPECT_THROW(write_picture(folder_ / "a.exr", sample(xyz_color_space()), stopped), Cancelled);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.exr"));
}

TEST_F(PictureFileTest, ExrChannelsGoByTheirNames) {
  EXPECT_EQ(pixel(read(kRgb("")), 1, 0), (Values{6, 4, 2}) /* B B G G R R */);
  EXPECT_EQ(pixel(read(exr({.rows = {-0.5f, 7e5f}})), 1, 0), (Values{7e5f, 7e5f, 7e5f}));
  EXPECT_EQ(pixel(read(exr({.channels = {"depth"}, .rows = {-0.5f, 7}})), 0, 0),
            (Values{-0.5f, -0.5f, -0.5f}));
  const PictureFile xyz = read(exr({.channels = {"X", "Y", "Z"}, .rows = {1, 2, 3, 4, 5, 6}}));
  EXPECT_TRUE(xyz.picture.color_space.is_xyz());
  EXPECT_EQ(pixel(xyz, 0, 0), (Values{1, 3, 5}));
  EXPECT_THAT(message_of(exr({.channels = {"U", "V"}, .rows = {0, 0, 0, 0}})),
              HasSubstr("has channels U, V"));
}

TEST_F(PictureFileTest, FurtherChannelsAndAlphaAreIgnoredWithAWarning) {
  const PictureFile further =
      read(exr({.channels = {"B", "G", "R", "Z"}, .rows = {1, 2, 3, 4, 5, 6, 7, 8}}));
  EXPECT_EQ(pixel(further, 0, 0), (Values{5, 3, 1}));
  EXPECT_THAT(further.warnings, ElementsAre(HasSubstr("only some of the channels R, G, B, Z")));
  const PictureFile opaque = read(exr({.channels = {"A", "Y"}, .rows = {1, 1, 3, 4}}));
  EXPECT_THAT(opaque.warnings, IsEmpty());
  const PictureFile alpha = read(exr({.channels = {"A", "Y"}, .rows = {1, 0.5f, 3, 4}}));
  EXPECT_EQ(pixel(alpha, 1, 0), (Values{4, 4, 4}));
  EXPECT_THAT(alpha.warnings, ElementsAre("the alpha channel is ignored"));
}

TEST_F(PictureFileTest, IsBlackOutsideTheDataWindow) {
  const PictureFile small = read(exr({.x = 1,
                                      .y = 1,
                                      .width = 2,
                                      .height = 1,
                                      .full_width = 4,
                                      .full_height = 3,
                                      .rows = {0.5f, 9}}));
  EXPECT_EQ(small.picture.width(), 4);
  EXPECT_EQ(small.picture.height(), 3);
  EXPECT_EQ(pixel(small, 2, 1), (Values{9, 9, 9}));
  EXPECT_EQ(pixel(small, 3, 1), (Values{0, 0, 0}));
}

TEST_F(PictureFileTest, ChromaticitiesMakeTheColorSpace) {
  EXPECT_EQ(read(kRgb("")).picture.color_space.name(), "lin_rec709");
  const Values aces_cg = {0.713f, 0.293f, 0.165f, 0.83f, 0.128f, 0.044f, 0.32168f, 0.33767f};
  EXPECT_EQ(read(kRgb(chromaticities(aces_cg))).picture.color_space.name(), "acescg");
  const Values adobe = {0.64f, 0.33f, 0.21f, 0.71f, 0.15f, 0.06f, 0.3127f, 0.329f};
  const RgbColorSpace own = read(kRgb(chromaticities(adobe))).picture.color_space;
  EXPECT_EQ(own.name(), "custom");
  EXPECT_NEAR(own.primaries()[1].x, 0.21, 1e-6);  // A float's digits.
  EXPECT_NEAR(own.primaries()[1].y, 0.71, 1e-6);
  EXPECT_NEAR(own.white_xyz()[0], 0.3127 / 0.329, 1e-6);
  const std::string named = attribute("glare:colorSpace", "string", "adobe");
  EXPECT_EQ(read(kRgb(chromaticities(adobe) + named)).picture.color_space.name(), "adobe");
}

TEST_F(PictureFileTest, RefusesImpossibleChromaticities) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Values& bad : {Values{0, 0, 0, 0, 0, 0, 0, 0},
                            Values{0.64f, 0.33f, 0.64f, 0.33f, 0.15f, 0.06f, 0.3f, 0.3f},
                            Values{0.64f, nan, 0.3f, 0.6f, 0.15f, 0.06f, 0.3f, 0.3f}})
    EXPECT_THAT(message_of(kRgb(chromaticities(bad))), HasSubstr("the attribute chromaticities"));
  // Of another size, they are no chromaticities.
  EXPECT_EQ(
      read(kRgb(attribute("chromaticities", "chromaticities", "abc"))).picture.color_space.name(),
      "lin_rec709");
}

TEST_F(PictureFileTest, ATemplateIsAPicture) {
  GlareTemplate t;
  t.channels.fill(Image<float>(4, 3));
  t.color_space = xyz_color_space();
  t.channels[1](2, 1) = 5;
  write_template(folder_ / "t.exr", t);
  const PictureFile file = read_picture(folder_ / "t.exr", kMemory);
  EXPECT_TRUE(file.picture.color_space.is_xyz());
  EXPECT_EQ(file.picture.channels[1](2, 1), 5);
}

TEST_F(PictureFileTest, WholeNumbersAreDecodedBySrgb) {
  // 188 / 255 is 0.502886 of white, 10 / 255 = 0.039216 lies on the straight part: / 12.92.
  const PictureFile png8 =
      read(png({.width = 1, .bits = 8, .color_type = 2, .pixels = "\0\xBC\x0A\xFF"s}));
  EXPECT_TRUE(png8.was_display_encoded);
  expect_near(pixel(png8, 0, 0), {0.502886f, 0.00303527f, 1}, kRounding);
  const PictureFile pgm = read("P5 1 1 65535\n\x80\x00"s);
  EXPECT_TRUE(pgm.was_display_encoded);
  expect_near(pixel(pgm, 0, 0), {0.214048f, 0.214048f, 0.214048f}, kRounding);
  const PictureFile tiff8 = read(tiff(tiff_tags(2, 1, 8, 2), "\0\xBC"s));
  EXPECT_TRUE(tiff8.was_display_encoded);
  expect_near(pixel(tiff8, 1, 0), {0.502886f, 0.502886f, 0.502886f}, kRounding);
}

TEST_F(PictureFileTest, FloatsAreLinear) {
  const PictureFile pfm = read("PF\n1 1\n-1\n" + floats({0.25f, 700, -3}));
  EXPECT_FALSE(pfm.was_display_encoded);
  EXPECT_EQ(pixel(pfm, 0, 0), (Values{0.25f, 700, -3}));
  // 128 / 256 * 2^(130 - 128).
  const PictureFile radiance = read(hdr("-Y 1 +X 1", "\x80\x40\x20\x82"));
  EXPECT_FALSE(radiance.was_display_encoded);
  expect_near(pixel(radiance, 0, 0), {2, 1, 0.5f}, 0.02f);  // Some decoders take its step's middle.
  const PictureFile tiff32 = read(tiff(tiff_tags(2, 1, 32, 8), floats({0.25f, 30})));
  EXPECT_FALSE(tiff32.was_display_encoded);
  EXPECT_EQ(pixel(tiff32, 1, 0), (Values{30, 30, 30}));
}

TEST_F(PictureFileTest, ReadsTheStoredFiles) {
  for (const char* name : {"ramp_zip.exr", "ramp_tiled_piz.exr", "ramp_two_parts.exr"}) {
    const PictureFile file = read_picture(fixture(name), kMemory);
    EXPECT_NEAR(file.picture.channels[2].values()[14], 17 * 14 / 255.0, kHalfRounding) << name;
  }
  EXPECT_TRUE(read_picture(fixture("grey.jpg"), kMemory).was_display_encoded);
}

TEST_F(PictureFileTest, TellsWhereAValueIsNotFinite) {
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_THAT(message_of(exr({.width = 3,
                              .height = 1,
                              .full_width = 3,
                              .full_height = 1,
                              .rows = {1, inf, std::nanf("")}})),
              HasSubstr("pixel (1, 0) isn't finite, the first of 2"));
}

TEST_F(PictureFileTest, RefusesWhatItCannotReadWithinTheLimit) {
  EXPECT_THROW(read_picture(folder_ / "none.exr", kMemory), InputError);
  EXPECT_THAT(message_of("wavelength,power\n380,1\n"), HasSubstr("is a text"));
  const std::string whole = kRgb("");
  for (std::size_t size = 0; size < whole.size(); size += 7)
    EXPECT_NE(message_of(whole.substr(0, size)), "nothing was refused") << size;
  // A display window of 60000 x 60000 takes 12 bytes a pixel, though 2 are stored.
  EXPECT_THROW(read(exr({.full_width = 60000, .full_height = 60000, .rows = {1, 2}})), MemoryError);
}

}  // namespace
}  // namespace glare::test
