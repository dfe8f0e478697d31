#include "glare/template/preview.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/templates.h"

namespace glare {
namespace {

float srgb(double v) {
  return static_cast<float>(v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055);
}

GlareTemplate grey_row(const std::vector<double>& luminances) {
  GlareTemplate t;
  t.channels.fill(test::picture(static_cast<int>(luminances.size()), 1,
                                [&](int x, int) { return luminances[x]; }));
  return t;
}

TEST(Preview, TheMiddleLuminanceIsHalfOfWhite) {
  // The median of the three that have light is 1.
  const auto shown = preview(grey_row({4, 1, 0.04, 0}), {1, 2});
  const auto sigmoid = [](double c) { return std::sqrt(c) / (std::sqrt(c) + 1); };
  EXPECT_NEAR(shown(0, 0)[0], srgb(sigmoid(4)), 1e-6);
  EXPECT_NEAR(shown(1, 0)[1], srgb(0.5), 1e-6);
  EXPECT_NEAR(shown(2, 0)[2], srgb(sigmoid(0.04)), 1e-6);
  EXPECT_EQ(shown(3, 0), (std::array<float, 3>{0, 0, 0}));
}

TEST(Preview, DoesNotDependOnTheTemplatesUnit) {
  const auto a = preview(grey_row({1, 1e-3, 1e-6})), b = preview(grey_row({4e7, 4e4, 4e1}));
  for (int x = 0; x < 3; ++x) EXPECT_NEAR(a(x, 0)[0], b(x, 0)[0], 1e-6);
  EXPECT_GT(a(0, 0)[0], a(1, 0)[0]);
  EXPECT_GT(a(1, 0)[0], a(2, 0)[0]);
  EXPECT_GT(a(2, 0)[0], 0.0005);  // Three decades below the median, and seen.
}

TEST(Preview, GreyStaysGreyAndColorsStayOnTheDisplay) {
  GlareTemplate t;
  std::uint32_t seed = 1;
  const auto random = [&](int, int) {
    seed = seed * 1664525 + 1013904223;
    return std::pow(10.0, -7.0 * (seed >> 8) / 16777216.0) * (seed % 5 == 0 ? -0.2 : 1);
  };
  for (auto& channel : t.channels) channel = test::picture(40, 40, random);
  t.channels[1](20, 20) = 100;
  const auto shown = preview(t);
  for (const auto& rgb : shown.values())
    for (const float value : rgb) {
      ASSERT_GE(value, 0);
      ASSERT_LE(value, 1);
    }
  const auto grey = preview(grey_row({1, 0.1, 1e-5}));
  for (const auto& rgb : grey.values()) {
    EXPECT_NEAR(rgb[0], rgb[1], 1e-6);
    EXPECT_NEAR(rgb[2], rgb[1], 1e-6);
  }
}

TEST(Preview, OfXyzShowsItsColor) {
  const GlareTemplate rgb = grey_row({1, 1e-4});
  GlareTemplate xyz = rgb;
  xyz.color_space = xyz_color_space();
  const Xyz white = lin_rec709_color_space().white_xyz();
  for (int k = 0; k < 3; ++k)
    for (float& value : xyz.channels[k].values()) value = static_cast<float>(value * white[k]);
  const auto a = preview(rgb), b = preview(xyz);
  for (int x = 0; x < 2; ++x)
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a(x, 0)[k], b(x, 0)[k], 1e-5);  // Single precision.
}

TEST(Preview, OfDarknessIsBlack) {
  const auto shown = preview(grey_row({0, 0}));
  for (const auto& rgb : shown.values()) EXPECT_EQ(rgb, (std::array<float, 3>{0, 0, 0}));
}

}  // namespace
}  // namespace glare
