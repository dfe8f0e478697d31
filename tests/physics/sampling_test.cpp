// Pixels: where the axis is, that each is a mean over its square, how far an aperture reaches.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <regex>
#include <string>

#include "glare/glare.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr double kPitch_rad = 1e-4;

const Aperture& aperture() {
  static const Aperture lopsided = test::lopsided({200, 200, 4});
  return lopsided;
}

Spectrum lamp() { return *find_lamp("LED-B4"); }

Image<float> luminance(int width, int height, double pitch_rad = kPitch_rad) {
  return test::luminance_of(aperture(), lamp(), test::absolute_xyz(width, height, pitch_rad));
}

TEST(Sampling, TheAxisIsTheMiddleOfPixelHalfWidthHalfHeight) {
  for (const int width : {1, 2, 3, 8, 33})
    for (const int height : {1, 2, 5, 32}) {
      const GlareTemplate t =
          make_template(aperture(), lamp(), test::absolute_xyz(width, height, 2e-5));
      const Peak brightest = peak(t);
      EXPECT_EQ(brightest.x, width / 2) << width << " x " << height;
      EXPECT_EQ(brightest.y, height / 2) << width << " x " << height;
      EXPECT_EQ(t.center_px(), (std::array{width / 2, height / 2}));
    }
}

TEST(Sampling, ATemplateOfAnotherShapeIsACropAtTheSamePitch) {
  const Image<float> square = luminance(161, 161);
  struct Size {
    int width, height;
  };
  for (const Size size : {Size{161, 40}, {40, 161}, {160, 160}, {97, 12}, {1, 161}}) {
    const Image<float> crop = luminance(size.width, size.height);
    const Image<float> expected =
        test::cropped(square, 80 - size.width / 2, 80 - size.height / 2, size.width, size.height);
    const auto off = test::difference(crop, expected);
    // Tiles begin elsewhere, so another number of wavelengths: single precision, and what the
    // quadrature leaves.
    EXPECT_LT(off.of_peak, 1e-6) << size.width << " x " << size.height;
    EXPECT_LT(off.relative, 5e-4) << size.width << " x " << size.height;
  }
}

TEST(Sampling, APixelIsTheMeanOverItsSquare) {
  for (const double pitch : {1e-5, 1e-4, 1.9e-4}) {
    const Image<float> fine = luminance(93, 93, pitch), coarse = luminance(31, 31, 3 * pitch);
    const Image<float> means = test::picture(31, 31, [&](int x, int y) {
      double sum = 0;
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) sum += fine(3 * x + i, 3 * y + j);
      return sum / 9;
    });
    const auto off = test::difference(coarse, means);
    // The interpolation's error, which the pixel's size and the zero-padding chosen for it change.
    EXPECT_LT(off.of_peak, 5e-4) << pitch;
    EXPECT_LT(off.relative, 0.01) << pitch;
  }
}

TEST(Sampling, TheNumberOfThreadsChangesNoBit) {
  auto options = test::absolute_xyz(150, 131, kPitch_rad);
  options.threads = 1;
  const GlareTemplate one = make_template(aperture(), lamp(), options);
  for (const int threads : {2, 3, 0}) {
    options.threads = threads;
    const GlareTemplate many = make_template(aperture(), lamp(), options);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(std::memcmp(one.channels[k].values().data(), many.channels[k].values().data(),
                            one.channels[k].values().size_bytes()),
                0)
          << threads << " threads, channel " << k;
  }
}

TEST(Sampling, AFieldUpToTheReachIsDoneAndOneBeyondRefused) {
  TemplateOptions options;
  options.width = 20;
  options.height = 14;
  const WavelengthRange range = effective_range(lamp(), options);
  const double widest =
      widest_field_of_view_deg(aperture().pixel_mm(), range.lo_nm, pixel_grid(options));
  EXPECT_NEAR(widest, 380e-6 / 0.02 * 180 / std::numbers::pi, 1e-9);
  options.field_of_view_deg = widest;
  EXPECT_NO_THROW(make_template(aperture(), lamp(), options));
  options.field_of_view_deg = widest * 1.01;
  EXPECT_THROW(make_template(aperture(), lamp(), options), OptionError);
  options.width = 14;
  options.height = 20;  // Now it is the height that reaches farther.
  options.field_of_view_deg = widest * 14 / 20;
  EXPECT_NO_THROW(make_template(aperture(), lamp(), options));
  options.field_of_view_deg = widest * 0.75;
  EXPECT_THROW(make_template(aperture(), lamp(), options), OptionError);
}

TEST(Sampling, WhatTheRefusalAdvisesIsWithinReach) {
  TemplateOptions options;
  options.width = options.height = 16;
  options.field_of_view_deg = 7;
  std::string message;
  try {
    make_template(aperture(), lamp(), options);
  } catch (const OptionError& error) {
    message = error.what();
  }
  std::smatch found;
  ASSERT_TRUE(std::regex_search(message, found,
                                std::regex("--fov-deg ([0-9.]+), or an aperture with pixels of at "
                                           "most ([0-9.]+) um \\(([0-9]+) across")))
      << message;
  const int across = std::stoi(found[3]);
  EXPECT_LE(4e3 / across, std::stod(found[2]));
  const Aperture finer{Image<float>(across, across, 1.0f), 4};
  EXPECT_NO_THROW(make_template(finer, lamp(), options));
  options.field_of_view_deg = std::stod(found[1]);
  EXPECT_NO_THROW(make_template(aperture(), lamp(), options));
}

}  // namespace
}  // namespace glare
