// Moved, turned and mirrored apertures, and which way is right and down.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glare/glare.h"
#include "support/templates.h"

namespace glare {
namespace {

// Another order of summation in single precision, and tiles with other quadrature nodes.
constexpr double kRoundingOfPeak = 2e-6, kRelative = 1e-3;

const test::Frame kFrame{160, 160, 4};

Spectrum lamp() { return *find_lamp("HP5"); }

TemplateOptions options() { return test::absolute_xyz(127, 127, 1e-4); }

const Image<float>& upright() {
  static const Image<float> y = test::luminance_of(test::lopsided(kFrame), lamp(), options());
  return y;
}

template <typename FromX, typename FromY>
Aperture rearranged(const Aperture& from, const FromX& x_of, const FromY& y_of) {
  Aperture out = from;
  for (int y = 0; y < out.transmittance.height(); ++y)
    for (int x = 0; x < out.transmittance.width(); ++x)
      out.transmittance(x, y) = from.transmittance(x_of(x, y), y_of(x, y));
  return out;
}

void expect_same(const Image<float>& a, const Image<float>& b) {
  const auto off = test::difference(a, b);
  EXPECT_LT(off.of_peak, kRoundingOfPeak);
  EXPECT_LT(off.relative, kRelative);
}

TEST(Symmetry, AShiftedApertureHasTheSameTemplate) {
  const Aperture there = rearranged(
      test::lopsided(kFrame), [](int x, int) { return (x + 160 - 7) % 160; },
      [](int, int y) { return (y + 5) % 160; });
  const Image<float> y = test::luminance_of(there, lamp(), options());
  EXPECT_TRUE(std::ranges::equal(y.values(), upright().values()));  // Its open part is the same.
}

TEST(Symmetry, AShiftByPartOfASampleIsAlmostNone) {
  const auto pupil = [](double x_mm, double y_mm) {
    return test::luminance_of(test::circle({256, 256, 4}, 3, {x_mm, y_mm}), lamp(), options());
  };
  const auto off = test::difference(pupil(0.131, -0.07), pupil(0, 0));
  EXPECT_LT(off.of_peak, 1e-3);  // The grey samples of the edge are other ones.
}

TEST(Symmetry, ATurnedApertureTurnsTheTemplate) {
  const Aperture turned = rearranged(
      test::lopsided(kFrame), [](int, int y) { return y; }, [](int x, int) { return 159 - x; });
  const Image<float> y = test::luminance_of(turned, lamp(), options());
  expect_same(y, test::picture(127, 127, [](int i, int j) { return upright()(j, 126 - i); }));
  EXPECT_GT(test::difference(y, upright()).of_peak, 0.05) << "the aperture is no test";
}

TEST(Symmetry, AMirroredApertureMirrorsTheTemplate) {
  const Aperture mirrored = rearranged(
      test::lopsided(kFrame), [](int x, int) { return 159 - x; }, [](int, int y) { return y; });
  const Image<float> y = test::luminance_of(mirrored, lamp(), options());
  expect_same(y, test::picture(127, 127, [](int i, int j) { return upright()(126 - i, j); }));
  EXPECT_GT(test::difference(y, upright()).of_peak, 0.01) << "the aperture is no test";
}

TEST(Symmetry, EveryTemplateIsPointSymmetric) {
  for (int y = 0; y < 127; ++y)
    for (int x = 0; x < 127; ++x) ASSERT_EQ(upright()(x, y), upright()(126 - x, 126 - y));
}

/// The direction in which light spreads most, in degrees from right towards down, within (-90, 90].
double streak_deg(const Image<float>& image) {
  const int cx = image.width() / 2, cy = image.height() / 2;
  double xx = 0, xy = 0, yy = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const double light = image(x, y);
      xx += light * (x - cx) * (x - cx);
      xy += light * (x - cx) * (y - cy);
      yy += light * (y - cy) * (y - cy);
    }
  return std::atan2(2 * xy, xx - yy) / 2 * 180 / std::numbers::pi;
}

TEST(Symmetry, ATiltedSlitsStreakIsPerpendicularToIt) {
  for (const double slope_deg : {20.0, 70.0, -35.0}) {  // From right towards down.
    const double c = std::cos(slope_deg * std::numbers::pi / 180);
    const double s = std::sin(slope_deg * std::numbers::pi / 180);
    const Aperture slit = test::sampled({256, 256, 4}, [&](const test::Place& at) {
      const double along = c * at.x_mm + s * at.y_mm, across = -s * at.x_mm + c * at.y_mm;
      return std::exp(-along * along / (2 * 0.5 * 0.5) - across * across / (2 * 0.05 * 0.05));
    });
    const Image<float> y = test::luminance_of(slit, lamp(), test::absolute_xyz(151, 151, 1e-4));
    double expected = slope_deg + 90;
    if (expected > 90) expected -= 180;
    EXPECT_NEAR(streak_deg(y), expected, 0.5) << slope_deg;  // A square field cuts its ends.
  }
}

TEST(Symmetry, AnEdgeSpreadsLightAtRightAngles) {
  // A half-disc cut along a line that falls to the right by 30 degrees: its streak rises to the
  // right by 60.
  const double turn = 30 * std::numbers::pi / 180;
  const Aperture cut = test::sampled({512, 512, 4}, [&](const test::Place& at) {
    const double across = -std::sin(turn) * at.x_mm + std::cos(turn) * at.y_mm;
    return std::hypot(at.x_mm, at.y_mm) < 1.8 && across > 0 ? 1.0 : 0.0;
  });
  const Image<float> y = test::luminance_of(cut, lamp(), test::absolute_xyz(301, 301, 1e-4));
  const auto at = [&](double deg) {
    const double angle = deg * std::numbers::pi / 180;
    double sum = 0;
    for (int r = 60; r < 140; ++r)
      sum += y(150 + static_cast<int>(std::lround(r * std::cos(angle))),
               150 + static_cast<int>(std::lround(r * std::sin(angle))));
    return sum;
  };
  double brightest = 0, best_deg = 0;
  for (double deg = -90; deg < 90; deg += 1)
    if (at(deg) > brightest) {
      brightest = at(deg);
      best_deg = deg;
    }
  EXPECT_NEAR(best_deg, -60, 1.01);  // Steps of a degree.
  EXPECT_GT(brightest, 5 * at(60));  // Its mirror image has none.
}

}  // namespace
}  // namespace glare
