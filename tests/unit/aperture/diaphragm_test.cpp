#include "glare/aperture/diaphragm.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "glare/base/error.h"
#include "support/refusals.h"

namespace glare {
namespace {

constexpr double kPi = std::numbers::pi;

double open_area_mm2(const Aperture& aperture) {
  double sum = 0;
  for (const float t : aperture.transmittance.values()) sum += t;
  return sum * aperture.pixel_mm() * aperture.pixel_mm();
}

double max_difference(const Image<float>& a, const Image<float>& b) {
  double difference = 0;
  for (std::size_t i = 0; i < a.values().size(); ++i)
    difference = std::max(difference, std::abs(0.0 + a.values()[i] - b.values()[i]));
  return difference;
}

Image<float> box_averaged(const Image<float>& image, int factor) {
  Image<float> result(image.width() / factor, image.height() / factor);
  for (int y = 0; y < result.height() * factor; ++y)
    for (int x = 0; x < result.width() * factor; ++x)
      result(x / factor, y / factor) += image(x, y) / static_cast<float>(factor * factor);
  return result;
}

DiaphragmParameters blades(int count, double roundness = 0) {
  DiaphragmParameters parameters;
  parameters.blade_count = count;
  parameters.roundness = roundness;
  return parameters;
}

DiaphragmParameters dirty() {
  DiaphragmParameters parameters;
  parameters.dust_count = 20;
  parameters.scratch_count = 5;
  return parameters;
}

TEST(Diaphragm, PolygonHasItsArea) {
  // Areas are exact, so that only the rounding of edge pixels to float remains.
  for (const int count : {3, 4, 5, 6, 9, 32})
    for (const double max_pixel_mm : {0.3, 0.1, 0.013}) {
      DiaphragmParameters p = blades(count);
      p.rotation_deg = 7;
      const double area = count / 2.0 * 2.5 * 2.5 * std::sin(2 * kPi / count);
      EXPECT_NEAR(open_area_mm2(draw_diaphragm(p, max_pixel_mm)), area, 1e-6 * area) << count;
      EXPECT_DOUBLE_EQ(diaphragm_area_mm2(p), area);
    }
}

TEST(Diaphragm, FullyRoundBladesMakeACircle) {
  const double area = kPi * 2.5 * 2.5;
  for (const int count : {3, 6, 11}) {
    EXPECT_NEAR(diaphragm_area_mm2(blades(count, 1)), area, 1e-12 * area);
    // Chords instead of arcs: a millionth of a pixel all round.
    EXPECT_NEAR(open_area_mm2(draw_diaphragm(blades(count, 1), 0.05)), area, 1e-6 * area);
  }
}

TEST(Diaphragm, CurvedEdgesAddTheirSegments) {
  double last = 0;
  for (const double roundness : {0.0, 0.01, 0.3, 0.7, 1.0}) {
    const double area = open_area_mm2(draw_diaphragm(blades(5, roundness), 0.05));
    EXPECT_NEAR(area, diaphragm_area_mm2(blades(5, roundness)), 1e-6 * area) << roundness;
    EXPECT_GT(area, last);
    last = area;
  }
}

/// The distance from the centre at which the opening ends in a direction: half of it is open there.
double reach_mm(const Aperture& aperture, double clockwise_from_up_deg) {
  const double angle = clockwise_from_up_deg * kPi / 180;
  const double middle = 0.5 * aperture.transmittance.width() - 0.5;
  const double pixel = aperture.pixel_mm();
  double r = 0;
  const auto at = [&](double distance) {
    return aperture.transmittance(
        static_cast<int>(std::lround(middle + distance / pixel * std::sin(angle))),
        static_cast<int>(std::lround(middle - distance / pixel * std::cos(angle))));
  };
  while (at(r) >= 0.5f) r += 0.1 * pixel;
  return r;
}

TEST(Diaphragm, CornersPointWhereTheRotationSays) {
  DiaphragmParameters p = blades(5);
  for (const double rotation_deg : {0.0, 20.0, -50.0, 144.0}) {
    p.rotation_deg = rotation_deg;
    const Aperture aperture = draw_diaphragm(p, 0.005);
    for (int corner = 0; corner < 5; ++corner) {
      const double at = rotation_deg + 72 * corner;
      // Two pixels along an edge; a corner's last half-open pixel lies a little further in.
      EXPECT_NEAR(reach_mm(aperture, at), 2.5, 0.02) << rotation_deg;
      EXPECT_NEAR(reach_mm(aperture, at + 36), 2.5 * std::cos(kPi / 5), 0.01) << rotation_deg;
      EXPECT_NEAR(reach_mm(aperture, at + 18), 2.5 * std::cos(kPi / 5) / std::cos(kPi / 10), 0.01);
    }
  }
}

TEST(Diaphragm, TurnsIntoItselfByAnEdge) {
  for (const int count : {3, 6, 7}) {
    DiaphragmParameters turned = blades(count, 0.4);
    const Image<float> picture = draw_diaphragm(turned, 0.02).transmittance;
    turned.rotation_deg = 360.0 / count;
    // The same corners, in single precision.
    EXPECT_LT(max_difference(picture, draw_diaphragm(turned, 0.02).transmittance), 2e-5);
    turned.rotation_deg = 180.0 / count;
    EXPECT_GT(max_difference(picture, draw_diaphragm(turned, 0.02).transmittance), 0.9);
  }
}

TEST(Diaphragm, IsTheSameAtEveryResolution) {
  DiaphragmParameters p = dirty();
  p.roundness = 0.3;
  const double coarse_pixel = diaphragm_picture_width_mm(p) / 300;
  const Image<float> coarse = draw_diaphragm(p, coarse_pixel).transmittance;
  DiaphragmParameters clean = p;
  clean.dust_count = clean.scratch_count = 0;
  const Image<float> clean_coarse = draw_diaphragm(clean, coarse_pixel).transmittance;
  for (const int factor : {2, 3}) {
    // Exact areas, added up in single precision.
    EXPECT_LT(max_difference(
                  clean_coarse,
                  box_averaged(draw_diaphragm(clean, coarse_pixel / factor).transmittance, factor)),
              1e-5);
    // A product for a union where two edges share a pixel: up to 1/4.
    EXPECT_LT(
        max_difference(
            coarse, box_averaged(draw_diaphragm(p, coarse_pixel / factor).transmittance, factor)),
        0.25);
  }
}

TEST(Diaphragm, DustAndScratchesTakeTheirArea) {
  DiaphragmParameters p = blades(8, 1);
  p.dust_count = 4000;
  p.dust_diameter_mm = 0.01;
  const double bare = diaphragm_area_mm2(p);
  // The mean area of a disc whose diameter is evenly spread from half to one and a half: 13/12 of
  // the mean one's; a ripple of height h adds h^2 / 2, with h even up to 0.3 / order, 1.4 % in all.
  double ripples = 0;
  for (int order = 2; order <= 5; ++order) ripples += 0.09 / (6 * order * order);
  const double dust = 4000 * kPi * 0.005 * 0.005 * 13 / 12 * (1 + ripples);
  // 4000 specks of 54 % spread give 1 %; half of the specks on the rim and on others take 1 %.
  EXPECT_NEAR((bare - open_area_mm2(draw_diaphragm(p, 0.01))) / dust, 1, 0.05);

  p.dust_count = 0;
  p.scratch_count = 400;
  p.scratch_length_mm = 0.5;
  p.scratch_width_mm = 0.001;
  // Two thirds of length times width; a spread of 29 %, and what lies beyond the rim or is crossed.
  const double scratches = 400 * 2.0 / 3 * 0.5 * 0.001;
  EXPECT_NEAR((bare - open_area_mm2(draw_diaphragm(p, 0.01))) / scratches, 0.95, 0.05);
}

TEST(Diaphragm, IsRepeatableForASeedAndAnyNumberOfThreads) {
  DiaphragmParameters p = dirty();
  const Image<float> first = draw_diaphragm(p, 0.02, 1).transmittance;
  const Image<float> again = draw_diaphragm(p, 0.02, 2).transmittance;
  EXPECT_TRUE(std::ranges::equal(first.values(), again.values()));
  p.seed = 2;
  const Image<float> other = draw_diaphragm(p, 0.02).transmittance;
  EXPECT_FALSE(std::ranges::equal(first.values(), other.values()));
}

TEST(Diaphragm, ExtremeParametersAreDrawn) {
  DiaphragmParameters p = dirty();
  p.dust_diameter_mm = 5;
  p.scratch_length_mm = 200;
  p.scratch_width_mm = 1;
  p.dust_count = 1;
  p.scratch_count = 1;
  for (const double diameter_mm : {0.1, 200.0})
    for (const int count : {3, 32}) {
      p.diameter_mm = diameter_mm;
      p.blade_count = count;
      const Aperture drawn = draw_diaphragm(p, diameter_mm / 100);
      for (const float t : drawn.transmittance.values()) ASSERT_TRUE(t >= 0 && t <= 1);
    }
}

void expect_refused(void (*change)(DiaphragmParameters&), const char* name) {
  DiaphragmParameters parameters;
  change(parameters);
  test::expect_refused([&] { draw_diaphragm(parameters, 0.05); }, name);
}

TEST(Diaphragm, RefusesParametersOutsideTheirRange) {
  using P = DiaphragmParameters;
  expect_refused([](P& p) { p.diameter_mm = 0.09; }, "diameter_mm");
  expect_refused([](P& p) { p.diameter_mm = std::nan(""); }, "diameter_mm");
  expect_refused([](P& p) { p.blade_count = 2; }, "blade_count");
  expect_refused([](P& p) { p.blade_count = 33; }, "blade_count");
  expect_refused([](P& p) { p.roundness = -0.1; }, "roundness");
  expect_refused([](P& p) { p.roundness = 1.01; }, "roundness");
  expect_refused([](P& p) { p.rotation_deg = 361; }, "rotation_deg");
  expect_refused([](P& p) { p.dust_count = -1; }, "dust_count");
  expect_refused([](P& p) { p.dust_diameter_mm = 0; }, "dust_diameter_mm");
  expect_refused([](P& p) { p.scratch_count = 1001; }, "scratch_count");
  expect_refused([](P& p) { p.scratch_length_mm = 0; }, "scratch_length_mm");
  expect_refused([](P& p) { p.scratch_width_mm = 2; }, "scratch_width_mm");
}

TEST(Diaphragm, RefusesUselessPixels) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double max_pixel_mm : {0.0, -1.0, 1e-9, 0.5, infinity, std::nan("")})
    EXPECT_THROW(draw_diaphragm({}, max_pixel_mm), OptionError) << max_pixel_mm;
}

}  // namespace
}  // namespace glare
