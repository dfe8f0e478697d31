// What all formats have in common: which one it is, the range of values, limits.
#include "glare/io/image_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "glare/base/error.h"
#include "support/image_bytes.h"
#include "support/image_file_fixture.h"

namespace glare::test {
namespace {

namespace fs = std::filesystem;
using std::string_literals::operator""s;

Values ramp() {
  Values values;
  for (int i = 0; i < 15; ++i) values.push_back(static_cast<float>(17 * i) / 255);
  return values;
}

TEST_F(ImageFileTest, ReadsTheStoredFiles) {
  const auto values_of = [](const std::string& name) {
    const TransmittanceImage image = read_transmittance(fixture(name), kMemory);
    return Values(image.transmittance.values().begin(), image.transmittance.values().end());
  };
  expect_near(values_of("ramp_lzw.tif"), ramp(), kRounding);
  expect_near(values_of("ramp_deflate.tif"), ramp(), kRounding);
  for (const char* name : {"ramp_zip.exr", "ramp_tiled_piz.exr", "ramp_two_parts.exr"}) {
    expect_near(values_of(name), ramp(), kHalfRounding);
  }
  const Values grey = values_of("grey.jpg");
  for (int x = 0; x < 16; ++x) EXPECT_NEAR(grey[x], 16 * x / 255.0, 0.02) << x;  // It is lossy.
  const Values halves = values_of("black_white_progressive.jpg");
  for (int x = 0; x < 16; ++x) EXPECT_NEAR(halves[x], x < 8 ? 1 : 0, 0.02) << x;
  EXPECT_TRUE(contains(refusal(content_of(fixture("cmyk.jpg"))), "CMYK"));
}

TEST_F(ImageFileTest, TheContentTellsTheFormatNotTheName) {
  const fs::path path = put(tiff(tiff_tags(2, 1, 8, 2), "\0\xFF"s), "picture.png");
  EXPECT_EQ(read_transmittance(path, kMemory).transmittance(1, 0), 1);
}

TEST_F(ImageFileTest, SaysWhatAFileIsInstead) {
  const std::pair<std::string, std::string> cases[] = {
      {"", "the file is empty"},
      {"wavelength,power\n380,1\n", "is a text"},
      {"GIF89a......", "is a GIF"},
      {"%PDF-1.7\n", "is a PDF"},
      {"RIFF....WEBPVP8 ", "is a WebP"},
      {"\0\0\0\x18"
       "ftypheic"s,
       "is a HEIF"},
      {"\x01\x02\x03\x04\x05", "is of an unknown kind"},
      {"8BPS\0\1"s, "is a Photoshop file"},
      {"<?xml?><svg>", "is an SVG"},
      {"P", "is a text"}};
  for (const auto& [content, part] : cases) {
    EXPECT_REFUSED(content, part);
    EXPECT_REFUSED(content, content.empty() ? "" : "not an image that Glare reads (PNG, JPEG");
  }
}

TEST_F(ImageFileTest, MissingFilesAndFoldersAreInputErrors) {
  EXPECT_THROW(read_transmittance(folder_ / "missing.png", kMemory), InputError);
  EXPECT_THROW(read_transmittance(folder_, kMemory), InputError);
  EXPECT_THROW(read_transmittance("/dev/zero", kMemory), InputError);
}

TEST_F(ImageFileTest, ValuesOutsideTheRangeAreErrorsThatSayWhere) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const std::pair<float, std::string> cases[] = {
      {nan, "nan"}, {infinity, "inf"}, {-infinity, "-inf"}, {-0.25f, "-0.25"}, {1.5f, "1.5"}};
  for (const auto& [value, text] : cases) {
    const std::string message =
        refusal(exr({.height = 2, .full_height = 2, .rows = {0, 0, 0, value}}));
    EXPECT_TRUE(contains(message, "pixel (1, 1) is " + text)) << message;
  }
  EXPECT_EQ(values_from(exr({.rows = {1.0009f, 1}})), (Values{1, 1}));
  EXPECT_NE(refusal(exr({.rows = {1.002f, 1}})), "");
}

TEST_F(ImageFileTest, SizesAreCheckedBeforeAnythingIsAllocated) {
  EXPECT_REFUSED(png({.width = 2000000000, .height = 2000000000, .pixels = "\0\0"s}), "65535");
  EXPECT_REFUSED(png({.width = 65535, .height = 65535, .pixels = "\0\0"s}), "too little data");
  EXPECT_REFUSED(png({.width = 0, .pixels = "\0\0"s}), "no pixels");
  std::vector<TiffTag> tags = tiff_tags(65535, 65535, 8, 3);
  tag_of(tags, 259).values = {8};
  EXPECT_REFUSED(tiff(tags, "abc"), "too little data");
  const std::string sane = "P5 1000 1000 255\n" + std::string(1000000, '\x7F');
  EXPECT_EQ(image_from(sane, 64 << 20).transmittance.width(), 1000);
  EXPECT_THROW(image_from(sane, 5 << 20), MemoryError);
  EXPECT_THROW(image_from(sane, 1 << 10), MemoryError);
}

}  // namespace
}  // namespace glare::test
