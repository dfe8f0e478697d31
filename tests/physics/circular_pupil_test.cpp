// The pattern of Airy: a circular pupil in light of one wavelength. Published figures: rings are
// zeros and extrema of (2 J1(x) / x)^2, x = pi r D / lambda; energies are 1 - J0^2(x) - J1^2(x).

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "glare/glare.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr double kDiameter_mm = 3, kWavelength_nm = 555;
constexpr double kAngleUnit_rad = kWavelength_nm * 1e-6 / kDiameter_mm;  // lambda / D

// Its edge's grey samples carry t^2 where the open share is t: 2 pixel / (3 D) of the energy is
// missing, and what the template is divided by is too small by as much: 3.6e-4.
constexpr double kGreyEdge = 4e-4;

// Of a ring's place, in lambda / D: the interpolation between the far field's samples may leave
// some 1e-5 of the peak, and where the curve is as flat as on its rings that moves an extremum.
constexpr double kPlace = 8e-4;

const Aperture& pupil() {
  static const Aperture aperture = test::circle({2048, 2048, 3.3}, kDiameter_mm);
  return aperture;
}

/// Luminance along the axis' row, 50 pixels to each lambda / D, as shares of the peak.
struct Section {
  static constexpr double kPixels = 50;
  std::vector<double> value;

  Section() {
    const int reach = static_cast<int>(4.5 * kPixels);
    const Image<float> row =
        test::luminance_of(pupil(), test::line_lamp(kWavelength_nm),
                           test::absolute_xyz(2 * reach + 1, 1, kAngleUnit_rad / kPixels));
    for (int x = reach; x <= 2 * reach; ++x) value.push_back(row(x, 0) / row(reach, 0));
  }

  /// The extremum nearest to `guess` (in lambda / D) by the parabola through three pixels.
  struct Extremum {
    double place, value;
  };
  Extremum extremum(double guess, double sign) const {
    auto i = static_cast<std::size_t>(std::lround(guess * kPixels));
    while (sign * value[i + 1] > sign * value[i]) ++i;
    while (sign * value[i - 1] > sign * value[i]) --i;
    const double slope = (value[i + 1] - value[i - 1]) / 2;
    const double bend = value[i + 1] - 2 * value[i] + value[i - 1];
    return {(static_cast<double>(i) - slope / bend) / kPixels, value[i] - slope * slope / bend / 2};
  }
};

const Section& section() {
  static const Section section;
  return section;
}

TEST(CircularPupil, DarkRings) {
  for (const double ring : {1.219670, 2.233131, 3.238315, 4.241063}) {
    const auto found = section().extremum(ring, -1);
    EXPECT_NEAR(found.place, ring, kPlace);
    // A pixel's square holds a little light where its middle has none; and the interpolation.
    EXPECT_NEAR(found.value, 0, 1.5e-4);
    RecordProperty("dark_ring_" + std::to_string(ring), std::to_string(found.place));
  }
}

TEST(CircularPupil, BrightRingsAndTheirHeights) {
  struct Ring {
    double place, height;
  };
  for (const Ring ring :
       {Ring{1.634719, 0.0174979}, {2.679292, 0.0041580}, {3.698710, 0.0016006}}) {
    const auto found = section().extremum(ring.place, 1);
    EXPECT_NEAR(found.place, ring.place, kPlace);
    // The mean over a pixel of 0.02 lambda / D lies below the maximum, by 2e-4 of it for the peak
    // and up to 4e-4 for a ring.
    EXPECT_NEAR(found.value / ring.height, 1, 1e-3);
    RecordProperty("bright_ring_" + std::to_string(ring.place),
                   std::to_string(found.place) + " " + std::to_string(found.value));
  }
}

TEST(CircularPupil, FullWidthAtHalfMaximum) {
  const std::vector<double>& value = section().value;
  std::size_t i = 0;
  while (value[i + 1] > 0.5) ++i;
  const double half = static_cast<double>(i) + (value[i] - 0.5) / (value[i] - value[i + 1]);
  RecordProperty("fwhm", std::to_string(2 * half / Section::kPixels));
  EXPECT_NEAR(2 * half / Section::kPixels, 1.028994, 5e-4);  // A line for a curve, within a pixel.
}

TEST(CircularPupil, EncircledEnergy) {
  const GlareTemplate t = make_template(pupil(), test::line_lamp(kWavelength_nm),
                                        test::absolute_xyz(181, 181, kAngleUnit_rad / 20));
  struct Circle {
    double radius, energy;
  };
  for (const Circle c : {Circle{1.219670, 0.837785},
                         {2.233131, 0.909931},
                         {3.238315, 0.937647},
                         {4.241063, 0.952319}}) {
    const auto energy = encircled_energy(t, c.radius * kAngleUnit_rad * 180 / std::numbers::pi);
    ASSERT_TRUE(energy.has_value());
    EXPECT_NEAR(*energy, c.energy, kGreyEdge + 1e-4);  // And pixels that the circle cuts.
    RecordProperty("energy_" + std::to_string(c.radius), std::to_string(*energy));
  }
}

TEST(CircularPupil, OnTheAxisItIsAreaOverWavelengthSquared) {
  const double pixel = kAngleUnit_rad / 100;  // Its mean is 4e-5 below its middle's value.
  const Image<float> y =
      test::luminance_of(pupil(), test::line_lamp(kWavelength_nm), test::absolute_xyz(3, 3, pixel));
  RecordProperty("axis", std::to_string(y(1, 1)));
  EXPECT_NEAR(y(1, 1) / 2.2948e7, 1, kGreyEdge + 1e-4);
  // The samples' own figure, |T(0)|^2 / (area of energy lambda^2), leaves the edge out.
  double open = 0;
  for (const float t : pupil().transmittance.values()) open += t;
  const double open_mm2 = open * pupil().pixel_mm() * pupil().pixel_mm();
  const double lambda_mm = kWavelength_nm * 1e-6;
  const double expected = open_mm2 * open_mm2 / energy_area_mm2(pupil()) / (lambda_mm * lambda_mm);
  EXPECT_NEAR(y(1, 1) / expected, 1, 1e-4);
}

TEST(CircularPupil, FirstDarkRingOfThreeMillimetresInArcMinutes) {
  const double place_rad = section().extremum(1.22, -1).place * kAngleUnit_rad;
  EXPECT_NEAR(place_rad * 180 * 60 / std::numbers::pi, 0.776, 0.0015);  // kPlace, and three digits.
}

TEST(CircularPupil, TwiceTheWavelengthOrHalfThePupilIsTwiceThePattern) {
  const double pitch = kAngleUnit_rad / 4;
  const auto options = test::absolute_xyz(65, 65, pitch);
  const Spectrum lamp = test::line_lamp(kWavelength_nm, 0.05);
  const Image<float> whole = test::luminance_of(pupil(), lamp, options);
  Aperture half = pupil();
  half.width_mm /= 2;
  auto wide = test::absolute_xyz(65, 65, 2 * pitch);
  Image<float> scaled = test::luminance_of(half, lamp, wide);
  for (float& value : scaled.values()) value *= 4;
  // The same far field on another scale, to the rounding of single precision.
  EXPECT_LT(test::difference(scaled, whole).relative, 1e-4);
}

}  // namespace
}  // namespace glare
