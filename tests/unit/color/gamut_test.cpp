#include "glare/color/gamut.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "glare/color/color_space.h"

namespace glare {
namespace {

using Rgb = std::array<float, 3>;

const Vector3& weights() {
  static const Vector3 w = lin_rec709_color_space().xyz_from_rgb()[1];
  return w;
}

double luminance(const Rgb& rgb) {
  return weights()[0] * rgb[0] + weights()[1] * rgb[1] + weights()[2] * rgb[2];
}

TEST(Gamut, AColorInsideStaysAsItIs) {
  for (const Rgb& rgb : {Rgb{0, 0, 0}, {1, 0, 0}, {0.2f, 5, 1e-30f}, {1e9f, 1e9f, 1e9f}})
    EXPECT_EQ(desaturated_into_gamut(rgb, weights()), rgb);
}

TEST(Gamut, AColorOutsideMovesTowardsItsGreyJustToTheBorder) {
  for (const Rgb& rgb : {Rgb{-0.2f, 1, 0.3f},
                         {2, -0.1f, -0.3f},
                         {1e-8f, 1e-8f, -1e-9f},
                         {-1e6f, 3e6f, 2e5f},
                         {0.5f, 0.2f, -3}}) {
    const Rgb mapped = desaturated_into_gamut(rgb, weights());
    const double y = luminance(rgb);
    EXPECT_NEAR(luminance(mapped) / y, 1, 1e-6) << "single precision";
    EXPECT_EQ(*std::ranges::min_element(mapped), 0);
    const double keep = y / (y - *std::ranges::min_element(rgb));  // One factor for all channels.
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(mapped[k] / y, 1 + keep * (rgb[k] / y - 1), 2e-6) << "single precision";
  }
}

TEST(Gamut, AColorWithoutLuminanceIsBlack) {
  EXPECT_EQ(desaturated_into_gamut({-1, 0, 0}, weights()), (Rgb{0, 0, 0}));
  EXPECT_EQ(desaturated_into_gamut({1, -1, 0.1f}, weights()), (Rgb{0, 0, 0}));
}

TEST(Gamut, MappingAgainChangesNothing) {
  const Rgb once = desaturated_into_gamut({-0.2f, 1, 0.3f}, weights());
  EXPECT_EQ(desaturated_into_gamut(once, weights()), once);
}

}  // namespace
}  // namespace glare
