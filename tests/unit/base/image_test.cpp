#include "glare/base/image.h"

#include <gtest/gtest.h>

#include <array>

namespace glare {
namespace {

TEST(Image, IsFilledAndRowMajor) {
  Image<float> image(3, 2, 7.5f);
  EXPECT_EQ(image.width(), 3);
  EXPECT_EQ(image.height(), 2);
  EXPECT_FALSE(image.empty());
  for (const float value : image.values()) EXPECT_EQ(value, 7.5f);
  image(2, 0) = 1;
  image(0, 1) = 2;
  EXPECT_EQ(image.values()[2], 1);
  EXPECT_EQ(image.values()[3], 2);
  EXPECT_EQ(image.row(1).data(), &image(0, 1));
  EXPECT_EQ(image.row(1).size(), 3u);
  const Image<float>& read_only = image;
  EXPECT_EQ(read_only.row(0)[2], 1);
  EXPECT_EQ(read_only.values().size(), 6u);
}

TEST(Image, WithoutPixelsIsEmpty) {
  EXPECT_TRUE(Image<float>().empty());
  EXPECT_TRUE(Image<float>(5, 0).empty());
  EXPECT_TRUE(Image<float>(0, 5).row(4).empty());
}

TEST(Image, IsAValue) {
  Image<std::array<float, 3>> a(2, 2);
  Image<std::array<float, 3>> b = a;
  b(1, 1) = {1, 2, 3};
  EXPECT_EQ(a(1, 1)[2], 0);
  EXPECT_EQ(b(1, 1)[2], 3);
}

}  // namespace
}  // namespace glare
