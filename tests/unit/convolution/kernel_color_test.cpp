// Colours of kernels: the lamp's, the template's and the picture's.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glare/convolution/pixel_kernel.h"
#include "glare/spectrum/lamps.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr PixelScale kScale{1e-4, 1};
constexpr double kSinglePrecision = 1e-6;

GlareTemplate template_of(const Spectrum& lamp, const RgbColorSpace& space,
                          WhiteAdaptation white = WhiteAdaptation::none) {
  TemplateOptions options = test::small_options();
  options.color_space = space;
  options.white = white;
  return make_template(test::small_pupil(), lamp, options);
}

GlareTemplate template_of(const char* lamp, WhiteAdaptation white = WhiteAdaptation::none) {
  return template_of(*find_lamp(lamp), lin_rec709_color_space(), white);
}

PixelKernelOptions with_lamp_color() {
  PixelKernelOptions options;
  options.lamp_color = PixelKernelOptions::LampColor::kept;
  return options;
}

Vector3 totals(const PixelKernel& kernel) {
  Vector3 result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = kernel.captured[k] + kernel.kept[k];
  return result;
}

RgbColorSpace acescg() {
  return {"acescg",
          {{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}}},
          xyz_from_chromaticity({0.32168, 0.33767})};
}

TEST(KernelColor, DaylightLeavesWhiteAsItIs) {
  const GlareTemplate t = template_of("D65");
  for (const auto& options : {PixelKernelOptions{}, with_lamp_color()}) {
    const PixelKernel kernel = pixel_kernel(t, kScale, lin_rec709_color_space(), options);
    // Of the CIE's table from 380 nm on, the white is not quite (0.3127, 0.3290).
    for (const double total : totals(kernel)) EXPECT_NEAR(total, 1, 2e-3);
    for (const double captured : kernel.captured) EXPECT_NEAR(captured, t.captured_energy, 0.02);
  }
}

TEST(KernelColor, TheLampsColorIsDividedOut) {
  const GlareTemplate t = template_of("hid");
  const PixelKernel divided = pixel_kernel(t, kScale, lin_rec709_color_space());
  const PixelKernel colored = pixel_kernel(t, kScale, lin_rec709_color_space(), with_lamp_color());
  const Vector3 lamp = lin_rec709_color_space().rgb_from_xyz() * t.lamp_xyz;
  EXPECT_GT(lamp[0], 1.05 * lamp[2]);  // It isn't white.
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(totals(divided)[k], 1, 1e-12);
    EXPECT_NEAR(totals(colored)[k], lamp[k], 1e-12);
    EXPECT_NEAR(divided.captured[k], t.captured_energy, 0.02);  // Field and lamp are nearly grey.
    for (std::size_t i = 0; i < divided.channels[k].values().size(); ++i)
      EXPECT_NEAR(divided.channels[k].values()[i] * lamp[k], colored.channels[k].values()[i],
                  kSinglePrecision);
  }
}

TEST(KernelColor, ATemplateAdaptedToItsLampIsWhite) {
  const GlareTemplate t = template_of("hid", WhiteAdaptation::lamp);
  EXPECT_EQ(t.light_xyz, t.color_space.white_xyz());
  EXPECT_EQ(template_of("hid").light_xyz, t.lamp_xyz);
  for (const auto& options : {PixelKernelOptions{}, with_lamp_color()}) {
    const PixelKernel kernel = pixel_kernel(t, kScale, lin_rec709_color_space(), options);
    for (const double total : totals(kernel)) EXPECT_NEAR(total, 1, 1e-12);
    for (const double captured : kernel.captured) EXPECT_NEAR(captured, t.captured_energy, 0.02);
  }
}

TEST(KernelColor, LightOfTheWholeFieldIsWhatTheTemplateSays) {
  // Nearly all the light is in this field, so that the sum of the pixels shows its colour.
  for (const auto white : {WhiteAdaptation::none, WhiteAdaptation::lamp}) {
    TemplateOptions options = test::small_options();
    options.white = white;
    options.width = options.height = 256;
    options.field_of_view_deg = 0.69;
    const GlareTemplate t = make_template(test::small_pupil(), *find_lamp("A"), options);
    const PixelKernel kernel = pixel_kernel(t, {t.pixel_pitch_rad, 1}, lin_rec709_color_space());
    for (const double captured : kernel.captured) EXPECT_NEAR(captured, 0.9985, 1.5e-3);
  }
}

TEST(KernelColor, ThePicturesSpaceMayBeAnother) {
  const Spectrum lamp = *find_lamp("led");
  const PixelKernel converted =
      pixel_kernel(template_of(lamp, lin_rec709_color_space()), kScale, acescg());
  const PixelKernel direct = pixel_kernel(template_of(lamp, acescg()), kScale, acescg());
  EXPECT_EQ(converted.color_space.name(), "acescg");
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(converted.captured[k], direct.captured[k], kSinglePrecision);
    EXPECT_LT(test::difference(converted.channels[k], direct.channels[k]).relative, 1e-5);
  }
}

TEST(KernelColor, WhereTheLampHasNoneAChannelIsThatOfLuminance) {
  // Sodium's blue is negative in BT.709, and X of light at 500 nm under a hundredth of Y.
  PixelKernelOptions luminance;
  luminance.luminance_only = true;
  const auto expect_dark = [&](const GlareTemplate& t, const RgbColorSpace& space,
                               std::array<bool, 3> is_dark) {
    const PixelKernel own = pixel_kernel(t, kScale, space);
    const PixelKernel grey = pixel_kernel(t, kScale, space, luminance);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(std::ranges::equal(own.channels[k].values(), grey.channels[k].values()), is_dark[k])
          << k;
      EXPECT_NEAR(totals(own)[k], 1, 1e-12);
      EXPECT_NEAR(own.captured[k], t.captured_energy, 0.02);
    }
  };
  const GlareTemplate sodium = template_of(test::line_lamp(589.3, 1), lin_rec709_color_space());
  expect_dark(sodium, lin_rec709_color_space(), {false, false, true});
  const GlareTemplate green = template_of(test::line_lamp(500, 1), xyz_color_space());
  expect_dark(green, xyz_color_space(), {true, true, false});
}

TEST(KernelColor, GreyPicturesGetTheLuminanceInEveryChannel) {
  PixelKernelOptions options;
  options.luminance_only = true;
  const GlareTemplate t = template_of("hid");
  const PixelKernel grey = pixel_kernel(t, kScale, acescg(), options);
  const PixelKernel xyz = pixel_kernel(t, kScale, xyz_color_space());
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(grey.captured[k], t.captured_energy, kSinglePrecision);
    EXPECT_TRUE(std::ranges::equal(grey.channels[k].values(), xyz.channels[1].values()));
  }
}

}  // namespace
}  // namespace glare
