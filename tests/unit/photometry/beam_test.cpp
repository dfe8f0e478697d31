#include "glare/photometry/beam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "support/beams.h"

namespace glare {
namespace {

using test::sampled;
using test::steps;

constexpr double kPi = std::numbers::pi, kDegree = kPi / 180;

/// The whole sphere in steps of one degree.
LuminousIntensityDistribution whole_sphere(PhotometricType type,
                                           const std::function<double(const Vector3&)>& beam) {
  const auto turn = type == PhotometricType::c ? steps(0, 360, 361) : steps(-180, 180, 361);
  if (type == PhotometricType::c) return sampled(type, turn, steps(0, 180, 181), beam);
  const auto polar = steps(-90, 90, 181);
  return type == PhotometricType::a ? sampled(type, turn, polar, beam)
                                    : sampled(type, polar, turn, beam);
}

constexpr PhotometricType kTypes[] = {PhotometricType::a, PhotometricType::b, PhotometricType::c};

TEST(Beam, FluxOfTheIsotropicSource) {
  for (const auto type : kTypes) {
    const auto lamp = whole_sphere(type, [](const Vector3&) { return 3; });
    EXPECT_NEAR(luminous_flux_lm(lamp), 4 * kPi * 3, 1e-11);  // Rounding.
  }
  const LuminousIntensityDistribution uneven(PhotometricType::c, {0, 7, 100, 360}, {0, 1, 50, 180},
                                             Image<float>(4, 4, 3));
  EXPECT_NEAR(luminous_flux_lm(uneven), 4 * kPi * 3, 1e-12);
}

TEST(Beam, FluxOfTheLambertianSource) {
  // In the mean over a step h, chords of a cosine are h^2 / 12 = 2.54e-5 of it too low; where the
  // source depends on both angles, that comes twice.
  const double tolerance = kPi * 100 * 5.2e-5;
  for (const auto type : kTypes) {
    EXPECT_NEAR(luminous_flux_lm(whole_sphere(
                    type, [](const Vector3& d) { return 100 * std::max(0.0, -d[1]); })),
                kPi * 100, tolerance);
    EXPECT_NEAR(luminous_flux_lm(
                    whole_sphere(type, [](const Vector3& d) { return 100 * std::max(0.0, d[2]); })),
                kPi * 100, tolerance);
  }
}

TEST(Beam, FluxOfOneDegree) {
  // 5 cd within one degree of H and V above the horizon, linear to 0 within 1e-6 degrees.
  const std::vector<double> edges{-1e-6, 0, 1, 1 + 1e-6};
  Image<float> candela(4, 4);
  for (int j : {1, 2})
    for (int i : {1, 2}) candela(i, j) = 5;
  const double exact = 5 * kDegree * std::sin(kDegree);
  const double tolerance = exact * 3e-6;  // The two slopes, 1e-6 of the width each way.
  for (const auto type : {PhotometricType::a, PhotometricType::b})
    EXPECT_NEAR(luminous_flux_lm({type, edges, edges, candela}), exact, tolerance);
  // A cap of one degree about the axis: 2 pi (1 - cos 1 degree).
  Image<float> cap(2, 3, 5);
  cap(0, 2) = cap(1, 2) = 0;
  EXPECT_NEAR(luminous_flux_lm({PhotometricType::c, {0, 360}, {0, 1, 1 + 1e-6}, cap}),
              5 * 2 * kPi * (1 - std::cos(kDegree)), 5 * kPi * kDegree * kDegree * 3e-6);
}

/// I = 1000 exp(-a (1 - cos angle from the axis)).
std::function<double(const Vector3&)> round_beam(const Vector3& axis, double a) {
  return [=](const Vector3& d) {
    return 1000 * std::exp(-a * (1 - axis[0] * d[0] - axis[1] * d[1] - axis[2] * d[2]));
  };
}

double round_beam_width_deg(double a, double share) {
  return 2 * std::acos(1 + std::log(share) / a) / kDegree;
}

TEST(Beam, FluxPeakAndWidthsOfARoundBeam) {
  const double a = 100;
  for (const auto type : kTypes) {
    const Vector3 axis = direction_from_angles(PhotometricType::a, 5, -3);
    const auto lamp = whole_sphere(type, round_beam(axis, a));
    // h^2 / 12 of the intensity's Laplacian, of at most a per rad^2, both ways: 2 * 100 * 2.5e-5
    // at the peak, less in the mean.
    EXPECT_NEAR(luminous_flux_lm(lamp) / (2 * kPi * 1000 * (1 - std::exp(-2 * a)) / a), 1, 3e-3);
    const PeakIntensity peak = peak_intensity(lamp);
    const Vector3 towards = direction_from_angles(type, peak.horizontal_deg, peak.vertical_deg);
    EXPECT_GT(towards[0] * axis[0] + towards[1] * axis[1] + towards[2] * axis[2],
              std::cos(0.8 * kDegree));  // The nearest of a grid of one degree.
    EXPECT_GT(peak.candela, 980);
    const BeamWidths widths = beam_widths(lamp);
    // Interpolated to 1e-3 of the width, through a grid direction beside the axis.
    EXPECT_NEAR(widths.horizontal_deg.value(), round_beam_width_deg(a, 0.5), 0.15);
    EXPECT_NEAR(widths.vertical_deg.value(), round_beam_width_deg(a, 0.5), 0.15);
    EXPECT_NEAR(beam_widths(lamp, 0.1).vertical_deg.value(), round_beam_width_deg(a, 0.1), 0.3);
  }
}

TEST(Beam, WidthsAboutThePolesOfTypeC) {
  for (const double up : {-1.0, 1.0}) {
    const auto lamp = whole_sphere(PhotometricType::c, round_beam({0, up, 0}, 50));
    const BeamWidths widths = beam_widths(lamp);
    EXPECT_NEAR(widths.horizontal_deg.value(), round_beam_width_deg(50, 0.5), 0.02);
    EXPECT_NEAR(widths.vertical_deg.value(), round_beam_width_deg(50, 0.5), 0.02);
  }
}

TEST(Beam, WidthsThatLeaveWhatWasMeasured) {
  Image<float> ridge(3, 3, 10);
  for (int i = 0; i < 3; ++i) ridge(i, 0) = ridge(i, 2) = 0;
  const LuminousIntensityDistribution lamp(PhotometricType::a, {-10, 0, 10}, {-2, 0, 6}, ridge);
  EXPECT_FALSE(beam_widths(lamp).horizontal_deg.has_value());
  EXPECT_DOUBLE_EQ(beam_widths(lamp).vertical_deg.value(), 1 + 3);
  EXPECT_DOUBLE_EQ(beam_widths(lamp, 0.1).vertical_deg.value(), 1.8 + 5.4);
  const LuminousIntensityDistribution everywhere(PhotometricType::c, {0, 360}, {0, 90},
                                                 Image<float>(2, 2, 1));
  EXPECT_FALSE(beam_widths(everywhere).horizontal_deg.has_value());
  EXPECT_FALSE(beam_widths(everywhere).vertical_deg.has_value());
  const LuminousIntensityDistribution dark(PhotometricType::c, {0, 360}, {0, 90},
                                           Image<float>(2, 2));
  EXPECT_EQ(luminous_flux_lm(dark), 0);
  EXPECT_FALSE(beam_widths(dark).vertical_deg.has_value());
}

TEST(Beam, WidthsOfARoundBeamAreOneHoweverSteepItEnds) {
  Image<float> candela(2, 4, 1000);
  for (int i = 0; i < 2; ++i) candela(i, 2) = candela(i, 3) = 0;
  const LuminousIntensityDistribution lamp(PhotometricType::c, {0, 360}, {0, 0.5, 0.5001, 90},
                                           candela);
  const BeamWidths widths = beam_widths(lamp);
  EXPECT_NEAR(widths.vertical_deg.value(), 1.0001, 1e-9);
  EXPECT_NEAR(widths.horizontal_deg.value(), 1.0001, 1e-8);  // Found by halving, to 1e-9 a side.
}

TEST(Beam, WidthAcrossTheSeamOfAClosedCircle) {
  Image<float> candela(5, 3);
  candela(0, 1) = candela(4, 1) = 100;
  const LuminousIntensityDistribution lamp(PhotometricType::a, {-180, -90, 0, 90, 180},
                                           {-90, 0, 90}, candela);
  EXPECT_DOUBLE_EQ(beam_widths(lamp).horizontal_deg.value(), 90);
}

}  // namespace
}  // namespace glare
