#include "glare/template/glare_template.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "glare/base/error.h"

namespace glare {
namespace {

TEST(GlareTemplate, TheAxisIsPixelHalfWidthHalfHeight) {
  GlareTemplate t;
  t.channels.fill(Image<float>(7, 4));
  EXPECT_EQ(t.width(), 7);
  EXPECT_EQ(t.height(), 4);
  EXPECT_EQ(t.center_px(), (std::array{3, 2}));
  t.pixel_pitch_rad = std::numbers::pi / 360;
  EXPECT_DOUBLE_EQ(t.pixel_pitch_deg(), 0.5);
}

TEST(GlareTemplate, LuminanceIsThatOfItsColorSpace) {
  GlareTemplate t;
  for (int k = 0; k < 3; ++k) t.channels[k] = Image<float>(2, 2, static_cast<float>(k + 1));
  EXPECT_NEAR(t.luminance(1, 0), 0.2126 + 2 * 0.7152 + 3 * 0.0722, 2e-4);  // Rounded weights.
  t.color_space = xyz_color_space();
  EXPECT_EQ(t.luminance(1, 0), 2);
}

TEST(Normalization, NamesAndBack) {
  for (const auto n : {Normalization::peak, Normalization::energy, Normalization::absolute})
    EXPECT_EQ(normalization_from(to_string(n)), n);
  EXPECT_THROW(normalization_from("Peak"), OptionError);
}

}  // namespace
}  // namespace glare
