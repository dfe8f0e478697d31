#include "glare/aperture/eye.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "glare/base/error.h"
#include "support/eyes.h"
#include "support/refusals.h"

namespace glare {
namespace {

double open_area_mm2(const Aperture& eye) {
  double sum = 0;
  for (const float t : eye.transmittance.values()) sum += t;
  return sum * eye.pixel_mm() * eye.pixel_mm();
}

/// Mean and second moments of the open part, in mm.
struct Moments {
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  explicit Moments(const Aperture& eye) {
    double sum = 0;
    const double middle = 0.5 * (eye.transmittance.width() - 1), pixel = eye.pixel_mm();
    for (int j = 0; j < eye.transmittance.height(); ++j)
      for (int i = 0; i < eye.transmittance.width(); ++i) {
        const double t = eye.transmittance(i, j), u = (i - middle) * pixel,
                     v = (j - middle) * pixel;
        sum += t;
        x += t * u;
        y += t * v;
        xx += t * u * u;
        yy += t * v * v;
        xy += t * u * v;
      }
    x /= sum;
    y /= sum;
    xx = xx / sum - x * x;
    yy = yy / sum - y * y;
    xy = xy / sum - x * y;
  }
};

Image<float> box_averaged(const Image<float>& image, int factor) {
  Image<float> result(image.width() / factor, image.height() / factor);
  for (int y = 0; y < result.height() * factor; ++y)
    for (int x = 0; x < result.width() * factor; ++x)
      result(x / factor, y / factor) += image(x, y) / static_cast<float>(factor * factor);
  return result;
}

struct Differences {
  double max = 0, mean = 0;

  Differences(const Image<float>& a, const Image<float>& b) {
    for (std::size_t i = 0; i < a.values().size(); ++i) {
      const double difference = std::abs(0.0 + a.values()[i] - b.values()[i]);
      max = std::max(max, difference);
      mean += difference / static_cast<double>(a.values().size());
    }
  }
};

bool same_picture(const Aperture& a, const Aperture& b) {
  return std::ranges::equal(a.transmittance.values(), b.transmittance.values());
}

TEST(Eye, PixelIsAtMostWhatWasAskedFor) {
  const double width_mm = eye_picture_width_mm({});
  for (const double max_pixel_mm : {0.3, 0.1, 0.0371, 0.01}) {
    const Aperture eye = draw_eye({}, max_pixel_mm);
    EXPECT_EQ(eye.transmittance.width(), eye.transmittance.height());
    EXPECT_EQ(eye.width_mm, width_mm);
    EXPECT_LE(eye.pixel_mm(), max_pixel_mm);
    EXPECT_GT(eye.width_mm / (eye.transmittance.width() - 1), max_pixel_mm);
  }
}

TEST(Eye, PixelThatDividesThePictureIsKept) {
  for (int size = 100; size < 200; ++size) {
    const double pixel_mm = eye_picture_width_mm(bare_pupil()) / size;
    EXPECT_EQ(draw_eye(bare_pupil(), pixel_mm).transmittance.width(), size);
  }
}

TEST(Eye, PupilHasTheAreaOfADiscOfItsDiameter) {
  // Areas are exact, so that only the rounding of edge pixels to float remains.
  for (const double diameter : {1.0, 2.5, 6.5, 10.0})
    for (const double ratio : {0.6, 0.97, 1.0}) {
      EyeParameters eye = bare_pupil();
      eye.pupil.diameter_mm = diameter;
      eye.pupil.axis_ratio = ratio;
      eye.pupil.longer_axis_deg = 0;  // Or the lids would hide some.
      eye.eyelids.opening_mm = 14;
      const double area = std::numbers::pi * diameter * diameter / 4;
      for (const double pixels : {20.0, 333.0})
        EXPECT_NEAR(open_area_mm2(draw_eye(eye, diameter / pixels)), area, 1e-6 * area)
            << diameter << ", " << ratio;
    }
}

TEST(Eye, RoundPupilIsGreyOnItsEdgeOnly) {
  const Aperture eye = draw_eye(round_pupil(), 0.05);
  const double pixel = eye.pixel_mm(), radius = 3.25;
  const double reach = pixel * std::numbers::sqrt2 / 2;  // half a pixel's diagonal
  const double middle = 0.5 * (eye.transmittance.width() - 1);
  int grey = 0;
  for (int y = 0; y < eye.transmittance.height(); ++y)
    for (int x = 0; x < eye.transmittance.width(); ++x) {
      const double r = pixel * std::hypot(x - middle, y - middle);
      const float t = eye.transmittance(x, y);
      if (std::abs(r - radius) > reach + 1e-5) {
        ASSERT_EQ(t, r < radius ? 1 : 0) << x << ", " << y;
      }
      grey += t > 0 && t < 1;
    }
  // A circle of radius r crosses 8 r / pixel grid lines, and so as many pixels.
  EXPECT_NEAR(grey, 8 * radius / pixel, 8);
}

TEST(Eye, EllipseAndDecentringAreAsAskedFor) {
  EyeParameters eye = round_pupil();
  eye.pupil.axis_ratio = 0.8;
  eye.pupil.longer_axis_deg = 30;
  eye.pupil.decentring_x_mm = 0.4;
  eye.pupil.decentring_y_mm = -0.25;
  const Moments m(draw_eye(eye, 0.01));
  // The pixels' own second moment, 1e-5 mm^2 of 2 to 3, is the most of what is off.
  EXPECT_NEAR(m.x, 0.4, 1e-4);
  EXPECT_NEAR(m.y, -0.25, 1e-4);
  const double mean = (m.xx + m.yy) / 2, half = std::hypot((m.xx - m.yy) / 2, m.xy);
  EXPECT_NEAR(std::sqrt((mean - half) / (mean + half)), 0.8, 1e-4);
  // Anticlockwise as seen; y is down.
  EXPECT_NEAR(0.5 * std::atan2(-2 * m.xy, m.xx - m.yy) * 180 / std::numbers::pi, 30, 0.01);
}

TEST(Eye, OutlineDepartsFromTheEllipseByTheIrregularity) {
  EyeParameters rough = round_pupil();
  rough.pupil.crypt_irregularity_mm = 0.03;
  rough.pupil.ruff_irregularity_mm = 0.01;
  const Aperture drawn = draw_eye(rough, 0.002);
  const Image<float>& t = drawn.transmittance;
  const double middle = 0.5 * (t.width() - 1), pixel = drawn.pixel_mm();
  double sum = 0, squares = 0;
  constexpr int directions = 2000;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * i / directions;
    double radius = 3.5;
    const auto is_open = [&] {
      return t(static_cast<int>(std::lround(middle + radius / pixel * std::cos(angle))),
               static_cast<int>(std::lround(middle - radius / pixel * std::sin(angle)))) > 0.5;
    };
    while (!is_open()) radius -= 0.0005;
    sum += radius;
    squares += radius * radius;
  }
  const double mean = sum / directions;
  // sqrt(0.03^2 + 0.01^2), less a percent by the limit of three times it; steps of a pixel.
  EXPECT_NEAR(std::sqrt(squares / directions - mean * mean), 0.0316, 0.001);
}

/// The eye drawn with pixels and with halves, thirds and fifths of them, averaged.
void expect_same_at_every_resolution(const EyeParameters& eye, double max, double mean) {
  const double coarse_pixel = eye_picture_width_mm(eye) / 500;
  const Image<float> coarse = draw_eye(eye, coarse_pixel).transmittance;
  for (const int factor : {2, 3, 5}) {
    const Image<float> fine =
        box_averaged(draw_eye(eye, coarse_pixel / factor).transmittance, factor);
    ASSERT_EQ(fine.width(), coarse.width());
    const Differences off(coarse, fine);
    EXPECT_LT(off.max, max) << factor;
    EXPECT_LT(off.mean, mean) << factor;
  }
}

TEST(Eye, IsTheSameAtEveryResolution) {
  // Each shape is exact; where two share a pixel there is a product for a union: up to 1/4.
  expect_same_at_every_resolution(clear_eye(), 0.3, 5e-4);
  // And a particle, smaller than these pixels, may be behind a lash's edge or beside it.
  expect_same_at_every_resolution({}, 0.4, 1.5e-3);
}

TEST(Eye, IsRepeatableForASeedAndDifferentForAnother) {
  EyeParameters first, other;
  other.seed = 2;
  EXPECT_TRUE(same_picture(draw_eye(first, 0.03, 1), draw_eye(first, 0.03, 2)));
  EXPECT_FALSE(same_picture(draw_eye(first, 0.03), draw_eye(other, 0.03)));
  EXPECT_EQ(eye_picture_width_mm(first), eye_picture_width_mm(other));
}

/// Where the column at `x_mm` is open, from the top: the y of its first and last open pixel.
std::pair<double, double> open_column(const Aperture& eye, double x_mm) {
  const int size = eye.transmittance.width();
  const int x = static_cast<int>(x_mm / eye.pixel_mm() + size / 2.0);
  int first = size, last = 0;
  for (int y = 0; y < size; ++y)
    if (eye.transmittance(x, y) > 0.5) first = std::min(first, y), last = y;
  return {(first - size / 2.0) * eye.pixel_mm(), (last + 1 - size / 2.0) * eye.pixel_mm()};
}

TEST(Eye, LidsOpenAsFarAsAskedFor) {
  EyeParameters squinting = bare_pupil();
  squinting.eyelids = {3, 0.4};
  const Aperture eye = draw_eye(squinting, 0.01);
  const auto [top, bottom] = open_column(eye, 0);
  EXPECT_NEAR(top, -1.2, eye.pixel_mm());
  EXPECT_NEAR(bottom, 1.8, eye.pixel_mm());
  // Parabolas through the corners, 14.5 mm from the axis.
  const auto [side_top, side_bottom] = open_column(eye, 2);
  const double parabola = 1 - 4 / (14.5 * 14.5);
  EXPECT_NEAR(side_top, -1.2 * parabola, eye.pixel_mm());
  EXPECT_NEAR(side_bottom, 1.8 * parabola, eye.pixel_mm());
}

TEST(Eye, LashesAreAsWideAsAskedFor) {
  // Straight ones across the pupil, of one width. Each is of 67 to 100 % of the root's width, so
  // that many of them cover 83.5 % on average, times their number on the picture's width.
  EyeParameters eye = round_pupil();
  EyelashParameters& lashes = eye.upper_lashes;
  lashes.count = 200;
  lashes.length_mm = 20;
  lashes.root_width_mm = 0.06;
  lashes.tip_share = 1;
  lashes.droop_deg = 90;
  lashes.curl_deg = lashes.fan_deg = lashes.scatter_deg = lashes.clumping = 0;
  double covered = 0;
  constexpr int eyes = 20;
  for (std::uint64_t seed = 1; seed <= eyes; ++seed) {
    eye.seed = seed;
    const Aperture drawn = draw_eye(eye, 0.01);
    const int middle = drawn.transmittance.height() / 2;
    for (const float t : drawn.transmittance.row(middle)) covered += (1 - t) * drawn.pixel_mm();
    covered -= drawn.width_mm - 6.5;
  }
  // What two lashes share counts once: with shares s = 0.345 of a lash's pitch, as places are
  // chosen in a stratum each, (s - s^2 / 6 ...) is within 7 % of s, and chance leaves 2 %.
  const double expected = eyes * 6.5 / 29 * 200 * 0.06 * 0.835;
  EXPECT_LT(covered, 1.02 * expected);
  EXPECT_GT(covered, 0.91 * expected);
}

TEST(Eye, OneLashHasItsWidthAndTapers) {
  EyeParameters eye = round_pupil();
  EyelashParameters& lashes = eye.upper_lashes;
  lashes.count = 1;  // Somewhere on the lid: the seed's is in front of the pupil.
  lashes.length_mm = 20;
  lashes.root_width_mm = 0.3;
  lashes.tip_share = 0;
  lashes.droop_deg = 90;
  lashes.curl_deg = lashes.fan_deg = lashes.scatter_deg = lashes.clumping = 0;
  const auto width_at = [&](double y_mm) {
    const Aperture drawn = draw_eye(eye, 0.005);
    const int half = drawn.transmittance.height() / 2;
    const int row = half + static_cast<int>(std::lround(y_mm / drawn.pixel_mm()));
    const double y = (row - 0.5 * drawn.transmittance.height() + 0.5) * drawn.pixel_mm();
    double open = 0;
    for (const float t : drawn.transmittance.row(row)) open += t * drawn.pixel_mm();
    return 2 * std::sqrt(3.25 * 3.25 - y * y) - open;
  };
  double widest = 0;
  for (eye.seed = 1; widest < 0.05 && eye.seed < 50; ++eye.seed) widest = width_at(0);
  --eye.seed;
  ASSERT_GT(widest, 0.05);
  const double higher = width_at(-2), lower = width_at(2);
  // A straight taper: the middle is the mean.
  EXPECT_NEAR(widest, (higher + lower) / 2, 0.01 * widest);
  EXPECT_GT(higher, 1.1 * lower);
  EXPECT_LT(higher, 0.3);
}

TEST(Eye, ClumpingGathersTipsAndLeavesRoots) {
  EyeParameters loose = clear_eye(), clumped = clear_eye();
  loose.upper_lashes.clumping = 0;
  clumped.upper_lashes.clumping = 1;
  const Aperture a = draw_eye(loose, 0.02), b = draw_eye(clumped, 0.02);
  const int half = a.transmittance.height() / 2;
  double root_difference = 0, tip_difference = 0;
  for (int y = 0; y < half; ++y)
    for (int x = 0; x < a.transmittance.width(); ++x)
      (y < half / 4 ? root_difference : tip_difference) +=
          std::abs(a.transmittance(x, y) - b.transmittance(x, y));
  EXPECT_GT(tip_difference, 5 * root_difference);
}

TEST(Eye, LashesAndLidsOnlyTakeAway) {
  EyeParameters bare = clear_eye();
  bare.eyelids.opening_mm = 12;
  bare.upper_lashes.count = bare.lower_lashes.count = 0;
  const Image<float> open = draw_eye(bare, 0.02).transmittance;
  const Image<float> eye = draw_eye({}, 0.02).transmittance;
  for (std::size_t i = 0; i < eye.values().size(); ++i) {
    ASSERT_GE(eye.values()[i], 0);
    ASSERT_LE(eye.values()[i], open.values()[i]);
  }
}

TEST(Eye, LashesHangOverTheUpperHalf) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EyeParameters lashes = clear_eye(), bare = clear_eye();
    lashes.seed = bare.seed = seed;
    bare.upper_lashes.count = bare.lower_lashes.count = 0;
    const Image<float> a = draw_eye(lashes, 0.02).transmittance;
    const Image<float> b = draw_eye(bare, 0.02).transmittance;
    const int half = a.height() / 2;
    double hidden[2] = {0, 0}, open[2] = {0, 0};
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) {
        hidden[y >= half] += b(x, y) - a(x, y);
        open[y >= half] += b(x, y);
      }
    EXPECT_GT(hidden[0] / open[0], 0.06) << seed;
    EXPECT_LT(hidden[0] / open[0], 0.3) << seed;
    EXPECT_LT(hidden[1] / open[1], 0.05) << seed;
  }
}

TEST(Eye, ExtremeParametersAreDrawn) {
  for (const double diameter : {1.0, 10.0})
    for (const double droop : {-90.0, 90.0})
      for (const double curl : {0.0, 180.0}) {
        EyeParameters extreme;
        extreme.pupil.diameter_mm = diameter;
        extreme.pupil.axis_ratio = 0.5;
        extreme.pupil.crypt_irregularity_mm = extreme.pupil.ruff_irregularity_mm = 0.03 * diameter;
        for (EyelashParameters* lashes : {&extreme.upper_lashes, &extreme.lower_lashes}) {
          lashes->droop_deg = droop;
          lashes->curl_deg = curl;
          lashes->tip_share = 0;
          lashes->fan_deg = 90;
          lashes->scatter_deg = 45;
          lashes->clumping = 1;
        }
        EXPECT_NO_THROW(require_valid(draw_eye(extreme, diameter / 64)));
      }
}

void expect_refused(void (*change)(EyeParameters&), const char* name) {
  EyeParameters parameters;
  change(parameters);
  test::expect_refused([&] { draw_eye(parameters, 0.05); }, name);
}

TEST(Eye, RefusesParametersOutsideTheirRange) {
  using P = EyeParameters;
  expect_refused([](P& p) { p.pupil.diameter_mm = 0.9; }, "pupil diameter_mm");
  expect_refused([](P& p) { p.pupil.diameter_mm = 10.1; }, "pupil diameter_mm");
  expect_refused([](P& p) { p.pupil.diameter_mm = std::nan(""); }, "pupil diameter_mm");
  expect_refused([](P& p) { p.pupil.axis_ratio = 1.01; }, "axis_ratio");
  expect_refused([](P& p) { p.pupil.longer_axis_deg = 200; }, "longer_axis_deg");
  expect_refused([](P& p) { p.pupil.decentring_x_mm = 2; }, "decentring_x_mm");
  expect_refused([](P& p) { p.pupil.decentring_y_mm = -2; }, "decentring_y_mm");
  expect_refused([](P& p) { p.pupil.crypt_irregularity_mm = 0.3; }, "crypt_irregularity_mm");
  expect_refused([](P& p) { p.pupil.ruff_irregularity_mm = -1; }, "ruff_irregularity_mm");
  expect_refused([](P& p) { p.eyelids.opening_mm = 0; }, "eyelid opening_mm");
  expect_refused([](P& p) { p.eyelids.share_above = 1.1; }, "share_above");
  expect_refused([](P& p) { p.upper_lashes.count = -1; }, "upper lash count");
  expect_refused([](P& p) { p.lower_lashes.count = 1001; }, "lower lash count");
  expect_refused([](P& p) { p.lower_lashes.length_mm = 0; }, "lower lash length_mm");
  expect_refused([](P& p) { p.upper_lashes.root_width_mm = 0; }, "root_width_mm");
  expect_refused([](P& p) { p.upper_lashes.tip_share = 2; }, "tip_share");
  expect_refused([](P& p) { p.upper_lashes.droop_deg = 91; }, "droop_deg");
  expect_refused([](P& p) { p.upper_lashes.curl_deg = -1; }, "curl_deg");
  expect_refused([](P& p) { p.upper_lashes.fan_deg = 91; }, "fan_deg");
  expect_refused([](P& p) { p.upper_lashes.scatter_deg = 46; }, "scatter_deg");
  expect_refused([](P& p) { p.upper_lashes.clumping = 1.1; }, "clumping");
  expect_refused([](P& p) { p.motion.hippus_mm = 1; }, "hippus_mm");
  expect_refused([](P& p) { p.motion.blinks_per_minute = 41; }, "blinks_per_minute");
  expect_refused([](P& p) { p.time_s = -1; }, "time_s");
  expect_refused([](P& p) { p.time_s = std::nan(""); }, "time_s");
}

TEST(Eye, RefusesUselessPixels) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double max_pixel_mm : {0.0, -1.0, 1e-9, 0.5, infinity, std::nan("")})
    EXPECT_THROW(draw_eye({}, max_pixel_mm), OptionError) << max_pixel_mm;
}

}  // namespace
}  // namespace glare
