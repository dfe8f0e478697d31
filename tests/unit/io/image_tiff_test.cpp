// TIFF files.
#include "glare/io/image_file.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "support/image_bytes.h"
#include "support/image_file_fixture.h"

namespace glare::test {
namespace {

using std::string_literals::operator""s;

TEST_F(ImageFileTest, TiffValuesAreAsStored) {
  expect_near(values_from(tiff(tiff_tags(3, 1, 8, 3), "\x00\x33\xFF"s)), {0, 0.2f, 1}, kRounding);
  EXPECT_EQ(values_from(tiff(tiff_tags(2, 1, 32, 8), floats({0.25f, 1}))), (Values{0.25f, 1}));
  EXPECT_EQ(values_from(tiff(tiff_tags(2, 1, 16, 4), "\0\0\xFF\xFF"s, true)), (Values{0, 1}));
  expect_near(values_from(tiff(tiff_tags(2, 1, 16, 4), "\x80\0\x40\0"s, true)),
              {32768 / 65535.f, 16384 / 65535.f}, kRounding);
}

TEST_F(ImageFileTest, TiffBitsWithoutTheirTagAreBits) {
  std::vector<TiffTag> tags = tiff_tags(3, 2, 1, 2);
  std::erase_if(tags, [](const TiffTag& tag) { return tag.tag == 258; });
  EXPECT_EQ(values_from(tiff(tags, "\xA0\x40")), (Values{1, 0, 1, 0, 1, 0}));
}

TEST_F(ImageFileTest, TiffInWhichZeroIsWhiteIsTurned) {
  std::vector<TiffTag> tags = tiff_tags(3, 1, 8, 3);
  tag_of(tags, 262).values = {0};
  expect_near(values_from(tiff(tags, "\x00\x33\xFF"s)), {1, 0.8f, 0}, kRounding);
  tags = tiff_tags(2, 1, 16, 4);
  tag_of(tags, 262).values = {0};
  EXPECT_EQ(values_from(tiff(tags, "\0\0\xFF\xFF"s)), (Values{1, 0}));
}

TEST_F(ImageFileTest, TiffPalettesOfBothKindsReachOne) {
  for (const std::uint32_t step : {256u, 257u}) {
    std::vector<TiffTag> tags = tiff_tags(2, 1, 8, 2);
    tag_of(tags, 262).values = {3};
    std::vector<std::uint32_t> colors(768, 0);
    for (const std::size_t channel : {0u, 256u, 512u}) {
      colors[channel + 1] = 255 * step;
      colors[channel + 2] = 51 * step;
    }
    tags.insert(tags.end() - 1, {320, 3, colors});
    expect_near(values_from(tiff(tags, "\1\2"s)), {1, 0.2f}, kRounding);
  }
}

TEST_F(ImageFileTest, TiffAlphaIsNotMultipliedIn) {
  std::vector<TiffTag> tags = tiff_tags(2, 1, 8, 4);
  tag_of(tags, 258).values = {8, 8};
  tag_of(tags, 277).values = {2};
  tag_of(tags, 339) = {338, 3, {2}};
  expect_near(values_from(tiff(tags, "\x33\x80\x66\x10"s)), {0.2f, 0.4f}, kRounding);
}

TEST_F(ImageFileTest, TiffKindsThatAreNotRead) {
  const std::pair<int, std::uint32_t> changes[] = {{259, 4}, {259, 7}, {262, 5},  {262, 6},
                                                   {277, 5}, {339, 2}, {258, 12}, {278, 0}};
  for (const auto& [tag, value] : changes) {
    std::vector<TiffTag> tags = tiff_tags(3, 1, 8, 3);
    tag_of(tags, tag).values = {value};
    EXPECT_NE(refusal(tiff(tags, "abc")), "") << tag << " " << value;
  }
}

}  // namespace
}  // namespace glare::test
