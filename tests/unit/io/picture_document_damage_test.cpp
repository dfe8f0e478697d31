// OpenEXR files that are cut short, altered, or of a kind that isn't taken.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "support/image_bytes.h"
#include "support/picture_document_fixture.h"

namespace glare::test {
namespace {

using std::string_literals::operator""s;
using testing::HasSubstr;

std::string window(int x_min, int y_min, int x_max, int y_max) {
  std::string box;
  for (const int edge : {x_min, y_min, x_max, y_max})
    box += little(static_cast<std::uint32_t>(edge), 4);
  return box;
}

TEST_F(PictureDocumentTest, RefusesWhatIsCutShort) {
  for (const char* name : {"kept_upwards_zip.exr", "kept_tiles_piz.exr", "kept_dwaa.exr",
                           "kept_b44.exr", "kept_mipmap.exr"}) {
    const std::string whole = content_of(fixture(name));
    for (std::size_t size = 0; size < whole.size(); size += size < 1400 ? 5 : 83)
      EXPECT_NE(refused(whole.substr(0, size)), "nothing was refused") << name << " " << size;
  }
}

// At every byte, with both ends of each part.
TEST_F(PictureDocumentTest, RefusesASmallFileCutAnywhere) {
  const std::string whole = exr({.channels = {"B", "G", "R"}, .rows = {1, 2, 3, 4, 5, 6}});
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refused(whole.substr(0, size)), "nothing was refused") << size;
  EXPECT_EQ(pixel(document(whole + "x").picture(), 0, 0), (Values{5, 3, 1}));
}

// Whatever is taken is written; both are the same whatever unset memory holds (which the address
// sanitizer's and malloc's fillings show when the test is run with two of them).
TEST_F(PictureDocumentTest, AlteredFilesAreRefusedOrWritten) {
  std::mt19937 random(5);
  int taken = 0;
  for (const char* name : {"kept_rows.exr", "kept_tiles_piz.exr", "kept_dwaa.exr"}) {
    const std::string whole = content_of(fixture(name));
    for (int i = 0; i < 50; ++i) {
      std::string altered = whole;
      altered[random() % altered.size()] ^= static_cast<char>(1 << random() % 8);
      try {
        written(document(altered));
        ++taken;
      } catch (const InputError&) {
      } catch (const MemoryError&) {
      }
    }
  }
  EXPECT_GT(taken, 10);  // Altered values of uncompressed pixels, at least.
}

TEST_F(PictureDocumentTest, RefusesOtherKinds) {
  const std::string parts = content_of(fixture("kept_parts.exr"));
  EXPECT_THAT(refused(parts, 2), HasSubstr("deep"));
  EXPECT_THAT(refused(parts, 4), HasSubstr("has no part 4; it has 4"));
  std::string without_version = parts;
  without_version.replace(parts.find("version\0int\0"s), 7, "Version");
  EXPECT_THAT(refused(without_version), HasSubstr("deep part is incomplete"));
  EXPECT_THAT(refused(exr({.rows = {1, 2}, .channel_type = 0})), HasSubstr("whole numbers"));
  EXPECT_THAT(refused(exr({.channels = {"BY", "RY", "Y"}, .rows = {1, 2, 3, 4, 5, 6}})),
              HasSubstr("luminance and subsampled colour"));
  EXPECT_THAT(refused("wavelength,power\n380,1\n"), HasSubstr("is a text"));
}

TEST_F(PictureDocumentTest, RefusesAbsurdWindows) {
  const std::string file = exr({.rows = {1, 2}});
  const std::string data = "dataWindow\0box2i\0"s;
  EXPECT_THAT(refused(with(file, data, window(0, 0, -1, 0))), HasSubstr("empty data window"));
  EXPECT_THAT(refused(with(file, data, window(0, 5, 1, 0))), HasSubstr("empty data window"));
  EXPECT_THAT(refused(with(file, data, window(0, 0, 70000, 0))), HasSubstr("absurd size"));
  EXPECT_THAT(refused(with(file, data, window(-2147483647, 0, 2147483647, 0))),
              HasSubstr("absurd size"));
  EXPECT_NE(refused(with(file, data, window(0, 0, 60000, 60000))), "nothing was refused");
  EXPECT_NE(refused(with(file, data, window(2147483640, 0, 2147483641, 0))), "nothing was refused");
}

// A block that inflates to less than it should, with the right checksum.
TEST_F(PictureDocumentTest, RefusesBlocksWithTooFewPixels) {
  const std::string whole = content_of(fixture("kept_upwards_zip.exr"));
  const std::string wider = with(whole, "dataWindow\0box2i\0"s, window(-36, -2, 11, 9));
  EXPECT_THAT(refused(wider), HasSubstr("a block of pixels is damaged"));
  const std::string dwa = content_of(fixture("kept_dwaa.exr"));
  EXPECT_THAT(refused(with(dwa, "dataWindow\0box2i\0"s, window(-12, -2, 11, 9))),
              HasSubstr("a block of pixels is damaged"));
}

TEST_F(PictureDocumentTest, TakesNoMoreMemoryThanAllowed) {
  const std::filesystem::path path = fixture("kept_rows.exr");
  EXPECT_THROW(PictureDocument::read(path, {-1, "", 1000}), MemoryError);
  EXPECT_THROW(PictureDocument::read(path, {-1, "", 8000}), MemoryError);
  // Tiles of 65535 x 65535 for 7 x 4 pixels.
  const std::string tiles = with(content_of(fixture("kept_tiles.exr")), "tiles\0tiledesc\0"s,
                                 little(65535, 4) + little(65535, 4));
  EXPECT_ANY_THROW(document(tiles));
}

}  // namespace
}  // namespace glare::test
