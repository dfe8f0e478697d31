// Files that are cut short, altered, or made to crash decoders.
#include "glare/io/image_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "glare/base/error.h"
#include "support/image_bytes.h"
#include "support/image_file_fixture.h"

namespace glare::test {
namespace {

using std::string_literals::operator""s;

/// One small file of each format.
std::vector<std::string> samples() {
  std::vector<std::string> files = {
      png({.pixels = "\0\0\xFF"s}),
      png({.width = 3, .height = 2, .bits = 16, .color_type = 6, .pixels = std::string(50, '\0')}),
      tiff(tiff_tags(2, 1, 32, 8), floats({0.25f, 1})),
      tiff(tiff_tags(3, 1, 8, 3), "abc", true),
      bmp(1, 2, 24, "", "abcdefgh"),
      hdr("-Y 1 +X 8", "\x02\x02\x00\x08"s + "\x88\x80\x88\x80\x88\x80\x88\x80"s),
      "P5 3 2 255\nabcdef",
      "P2 2 1 4 1 4 ",
      "Pf\n1 2\n-1.0\n" + floats({0.25f, 0.75f}),
      exr({.rows = {0.25f, 1}}),
      exr({.channels = {"A", "B", "G", "R"}, .rows = {1, 0, 0, 1, 0, 0, 1, 1}})};
  for (const char* name :
       {"grey.jpg", "black_white_progressive.jpg", "bad_profile.jpg", "ramp_lzw.tif",
        "ramp_deflate.tif", "ramp_zip.exr", "ramp_tiled_piz.exr", "ramp_two_parts.exr"}) {
    files.push_back(content_of(fixture(name)));
  }
  return files;
}

TEST_F(ImageFileTest, FilesCutShortAreErrors) {
  for (const std::string& file : samples()) {
    const Values whole = values_from(file);
    const std::size_t step = std::max<std::size_t>(1, file.size() / 200);
    for (std::size_t size = 0; size < file.size(); size += step) {
      // What comes after the last pixel may be missing, if the pixels are all right then.
      try {
        EXPECT_EQ(values_from(file.substr(0, size)), whole) << size << " of " << file.size();
        EXPECT_GT(size, file.size() * 9 / 20) << "read from so few bytes of " << file.size();
      } catch (const InputError&) {
      }
    }
  }
}

TEST_F(ImageFileTest, AlteredFilesAreReadOrRefused) {
  std::mt19937 random(1);
  for (const std::string& file : samples()) {
    for (int i = 0; i < 150; ++i) {
      std::string altered = file;
      const std::size_t range = i % 2 == 0 ? std::min<std::size_t>(file.size(), 64) : file.size();
      for (int changes = 1 + i % 3; changes > 0; --changes) {
        altered[random() % range] = static_cast<char>("\0\1\x7F\x80\xFF"s[random() % 5]);
      }
      try {
        image_from(altered);
      } catch (const Error&) {
      }
    }
  }
}

TEST_F(ImageFileTest, ColourProfilesThatCrashDecodersAreNotLookedAt) {
  expect_near(values_from(content_of(fixture("bad_profile.jpg"))), Values(256, 128 / 255.f),
              kRounding);
  const std::string jpeg = content_of(fixture("grey.jpg"));
  const std::string exif = "Exif\0\0MM\0*\0\0\0\x08\xFF\xFF"s;
  const std::string with_exif =
      jpeg.substr(0, 2) + "\xFF\xE1" + big(exif.size() + 2, 2) + exif + jpeg.substr(2);
  EXPECT_EQ(values_from(with_exif), values_from(jpeg));
  const std::string profile = png_chunk("iCCP", "x\0\0"s + stored(std::string(200, '\xFF'))) +
                              png_chunk("eXIf", "MM\0*" + std::string(80, '\xFF'));
  EXPECT_EQ(values_from(png({.pixels = "\0\0\xFF"s, .extra = profile})), (Values{0, 1}));
}

}  // namespace
}  // namespace glare::test
