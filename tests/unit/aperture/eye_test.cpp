#include "glare/aperture/eye.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "glare/base/error.h"

namespace glare {
namespace {

EyeParameters bare_pupil() {
  EyeParameters parameters;
  parameters.eyelash_count = 0;
  return parameters;
}

double open_area_mm2(const Aperture& eye) {
  double sum = 0;
  for (const float t : eye.transmittance.values()) sum += t;
  return sum * eye.pixel_mm() * eye.pixel_mm();
}

/// Mean of the rows from `first` to before `last`.
double mean_of_rows(const Image<float>& image, int first, int last) {
  double sum = 0;
  for (int y = first; y < last; ++y)
    for (const float t : image.row(y)) sum += t;
  return sum / (static_cast<double>(image.width()) * (last - first));
}

Image<float> box_averaged(const Image<float>& image, int factor) {
  Image<float> result(image.width() / factor, image.height() / factor);
  for (int y = 0; y < result.height() * factor; ++y)
    for (int x = 0; x < result.width() * factor; ++x)
      result(x / factor, y / factor) += image(x, y) / static_cast<float>(factor * factor);
  return result;
}

double max_difference(const Image<float>& a, const Image<float>& b) {
  double difference = 0;
  for (std::size_t i = 0; i < a.values().size(); ++i)
    difference = std::max(difference, std::abs(0.0 + a.values()[i] - b.values()[i]));
  return difference;
}

double mean_difference(const Image<float>& a, const Image<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.values().size(); ++i)
    sum += std::abs(0.0 + a.values()[i] - b.values()[i]);
  return sum / static_cast<double>(a.values().size());
}

bool same_picture(const Aperture& a, const Aperture& b) {
  return std::ranges::equal(a.transmittance.values(), b.transmittance.values());
}

TEST(Eye, PixelIsAtMostWhatWasAskedFor) {
  for (const double max_pixel_mm : {0.3, 0.1, 0.0371, 0.01}) {
    const Aperture eye = draw_eye({}, max_pixel_mm);
    EXPECT_EQ(eye.transmittance.width(), eye.transmittance.height());
    EXPECT_DOUBLE_EQ(eye.width_mm, 6.5 * 1.04);
    EXPECT_LE(eye.pixel_mm(), max_pixel_mm);
    EXPECT_GT(eye.width_mm / (eye.transmittance.width() - 1), max_pixel_mm);
  }
}

TEST(Eye, PixelThatDividesThePictureIsKept) {
  for (int size = 100; size < 200; ++size)
    EXPECT_EQ(draw_eye(bare_pupil(), 6.5 * 1.04 / size).transmittance.width(), size);
}

TEST(Eye, BarePupilHasTheAreaOfItsDisc) {
  // Areas are exact, so that only the rounding of edge pixels to float remains.
  const double area = std::numbers::pi * 6.5 * 6.5 / 4;
  for (const double max_pixel_mm : {0.4, 0.1, 0.03, 0.01, 0.005})
    EXPECT_NEAR(open_area_mm2(draw_eye(bare_pupil(), max_pixel_mm)), area, 1e-7 * area)
        << max_pixel_mm;
}

TEST(Eye, BarePupilIsSymmetric) {
  for (const int size : {128, 129}) {
    const Image<float> t = draw_eye(bare_pupil(), 6.5 * 1.04 / size).transmittance;
    ASSERT_EQ(t.width(), size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        // Exact areas, rounded to float.
        EXPECT_NEAR(t(x, y), t(y, x), 1e-6);
        EXPECT_NEAR(t(x, y), t(size - 1 - x, y), 1e-6);
        EXPECT_NEAR(t(x, y), t(x, size - 1 - y), 1e-6);
      }
  }
}

TEST(Eye, BarePupilIsGreyOnItsEdgeOnly) {
  const Aperture eye = draw_eye(bare_pupil(), 0.05);
  const double pixel = eye.pixel_mm(), radius = 3.25;
  const double reach = pixel * std::numbers::sqrt2 / 2;  // half a pixel's diagonal
  const double middle = 0.5 * (eye.transmittance.width() - 1);
  int grey = 0;
  for (int y = 0; y < eye.transmittance.height(); ++y)
    for (int x = 0; x < eye.transmittance.width(); ++x) {
      const double r = pixel * std::hypot(x - middle, y - middle);
      const float t = eye.transmittance(x, y);
      if (std::abs(r - radius) > reach) {
        ASSERT_EQ(t, r < radius ? 1 : 0) << x << ", " << y;
      }
      grey += t > 0 && t < 1;
    }
  // A circle of radius r crosses 8 r / pixel grid lines, and so as many pixels.
  EXPECT_NEAR(grey, 8 * radius / pixel, 8);
}

TEST(Eye, IsTheSameAtEveryResolution) {
  const double coarse_pixel = 6.5 * 1.04 / 500;
  const Image<float> coarse = draw_eye({}, coarse_pixel).transmittance;
  for (const int factor : {2, 3, 5}) {
    const Image<float> fine =
        box_averaged(draw_eye({}, coarse_pixel / factor).transmittance, factor);
    ASSERT_EQ(fine.width(), coarse.width());
    // Areas are exact but where two lashes share an edge pixel (a product for a union: up to 1/4)
    // and at the ends of lashes.
    EXPECT_LT(max_difference(coarse, fine), 0.3);
    EXPECT_LT(mean_difference(coarse, fine), 5e-4);
  }
}

TEST(Eye, OpenAreaDoesNotDependOnThePixel) {
  const double area = open_area_mm2(draw_eye({}, 0.004));
  // Thinner than a pixel at their tips, the lashes still take their own area away. What is left is
  // the product for a union where lashes cross.
  for (const double max_pixel_mm : {0.05, 0.02, 0.008})
    EXPECT_NEAR(open_area_mm2(draw_eye({}, max_pixel_mm)), area, 2e-3 * area) << max_pixel_mm;
}

TEST(Eye, IsRepeatableForASeedAndDifferentForAnother) {
  EyeParameters first, other;
  other.seed = 2;
  EXPECT_TRUE(same_picture(draw_eye(first, 0.03), draw_eye(first, 0.03)));
  EXPECT_FALSE(same_picture(draw_eye(first, 0.03), draw_eye(other, 0.03)));
}

TEST(Eye, LashesHangOverTheUpperHalf) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EyeParameters parameters;
    parameters.seed = seed;
    const Image<float> bare = draw_eye(bare_pupil(), 0.02).transmittance;
    const Image<float> eye = draw_eye(parameters, 0.02).transmittance;
    const int half = eye.height() / 2;
    const auto blocked = [&](int first, int last) {
      return 1 - mean_of_rows(eye, first, last) / mean_of_rows(bare, first, last);
    };
    EXPECT_GT(blocked(0, half), 0.1) << seed;
    EXPECT_LT(blocked(0, half), 0.35) << seed;
    EXPECT_LT(blocked(eye.height() - half, eye.height()), 0.02) << seed;
  }
}

TEST(Eye, LashesOnlyTakeAway) {
  const Image<float> bare = draw_eye(bare_pupil(), 0.02).transmittance;
  const Image<float> eye = draw_eye({}, 0.02).transmittance;
  for (std::size_t i = 0; i < eye.values().size(); ++i) {
    ASSERT_GE(eye.values()[i], 0);
    ASSERT_LE(eye.values()[i], bare.values()[i]);
  }
}

TEST(Eye, ReachAndWidthDoWhatTheySay) {
  EyeParameters shorter, thinner;
  shorter.eyelash_reach = 0.3;
  thinner.eyelash_root_width_mm = 0.05;
  const double area = open_area_mm2(draw_eye({}, 0.02));
  const double bare = open_area_mm2(draw_eye(bare_pupil(), 0.02));
  EXPECT_GT(open_area_mm2(draw_eye(shorter, 0.02)), area);
  // Half the width takes half the area, but for what crossing lashes share.
  EXPECT_NEAR((bare - open_area_mm2(draw_eye(thinner, 0.02))) / (bare - area), 0.5, 0.06);
}

TEST(Eye, ExtremeParametersAreDrawn) {
  for (const double diameter : {1.0, 10.0})
    for (const double reach : {0.0, 1.0}) {
      EyeParameters extreme;
      extreme.pupil_diameter_mm = diameter;
      extreme.eyelash_reach = reach;
      extreme.eyelash_fan_deg = 60;
      extreme.eyelash_root_width_mm = 0.5;
      EXPECT_NO_THROW(require_valid(draw_eye(extreme, diameter / 64)));
    }
}

void expect_refused(void (*change)(EyeParameters&), const char* name) {
  EyeParameters parameters;
  change(parameters);
  try {
    draw_eye(parameters, 0.05);
    ADD_FAILURE() << name << " was accepted";
  } catch (const OptionError& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

TEST(Eye, RefusesParametersOutsideTheirRange) {
  using P = EyeParameters;
  expect_refused([](P& p) { p.pupil_diameter_mm = 0.9; }, "pupil_diameter_mm");
  expect_refused([](P& p) { p.pupil_diameter_mm = 10.1; }, "pupil_diameter_mm");
  expect_refused([](P& p) { p.pupil_diameter_mm = std::nan(""); }, "pupil_diameter_mm");
  expect_refused([](P& p) { p.eyelash_count = -1; }, "eyelash_count");
  expect_refused([](P& p) { p.eyelash_count = 1001; }, "eyelash_count");
  expect_refused([](P& p) { p.eyelash_root_width_mm = 0; }, "eyelash_root_width_mm");
  expect_refused([](P& p) { p.eyelash_root_width_mm = 0.6; }, "eyelash_root_width_mm");
  expect_refused([](P& p) { p.eyelash_reach = -0.1; }, "eyelash_reach");
  expect_refused([](P& p) { p.eyelash_reach = 1.1; }, "eyelash_reach");
  expect_refused([](P& p) { p.eyelash_fan_deg = -1; }, "eyelash_fan_deg");
  expect_refused([](P& p) { p.eyelash_fan_deg = 61; }, "eyelash_fan_deg");
}

TEST(Eye, RefusesUselessPixels) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double max_pixel_mm : {0.0, -1.0, 1e-9, 0.5, infinity, std::nan("")})
    EXPECT_THROW(draw_eye({}, max_pixel_mm), OptionError) << max_pixel_mm;
}

}  // namespace
}  // namespace glare
