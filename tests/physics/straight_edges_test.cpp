// Apertures whose far field is written in a line: slit, square, pinholes, grating.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "glare/glare.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kWavelength_nm = 550, kWavelength_mm = kWavelength_nm * 1e-6;

double sinc(double x) { return x == 0 ? 1 : std::sin(kPi * x) / (kPi * x); }

/// The mean of sinc^2 over [x - width / 2, x + width / 2], by Simpson's rule.
double mean_sinc2(double x, double width) {
  constexpr int kSteps = 16;
  double sum = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const double weight = i == 0 || i == kSteps ? 1 : i % 2 ? 4 : 2;
    const double s = sinc(x + width * (static_cast<double>(i) / kSteps - 0.5));
    sum += weight * s * s;
  }
  return sum / (3 * kSteps);
}

TEST(StraightEdges, FirstSideMaximumOfASlit) {
  constexpr double width_mm = 1;
  constexpr int pixels = 50;  // To lambda / width.
  const Aperture slit = test::slit({2048, 512, 2.048}, width_mm);
  const Image<float> row =
      test::luminance_of(slit, test::line_lamp(kWavelength_nm),
                         test::absolute_xyz(201, 1, kWavelength_mm / width_mm / pixels));
  int x = 100 + 143 * pixels / 100;
  while (row(x + 1, 0) > row(x, 0)) ++x;
  while (row(x - 1, 0) > row(x, 0)) --x;
  const double slope = (row(x + 1, 0) - row(x - 1, 0)) / 2;
  const double bend = row(x + 1, 0) - 2 * row(x, 0) + row(x - 1, 0);
  RecordProperty("place", std::to_string((x - 100 - slope / bend) / pixels));
  RecordProperty("height", std::to_string(row(x, 0) / row(100, 0)));
  // Interpolation between the far field's samples may leave 1e-4 of the peak, which moves so flat
  // an extremum.
  EXPECT_NEAR((x - 100 - slope / bend) / pixels, 1.430297, 1.5e-3);
  // The mean over the pixel lies below the maximum.
  EXPECT_NEAR((row(x, 0) - slope * slope / bend / 2) / row(100, 0) / 0.0471904, 1, 1e-3);
}

TEST(StraightEdges, ASquareIsSincSquaredBothWays) {
  constexpr double side_mm = 1, pixel = 0.25;  // In lambda / side.
  const Aperture square = test::square({2048, 2048, 2.048}, side_mm);
  const Image<float> y =
      test::luminance_of(square, test::line_lamp(kWavelength_nm, 0.05),
                         test::absolute_xyz(41, 41, pixel * kWavelength_mm / side_mm));
  const Image<float> expected = test::picture(41, 41, [&](int i, int j) {
    return side_mm * side_mm / (kWavelength_mm * kWavelength_mm) *
           mean_sinc2((i - 20) * pixel, pixel) * mean_sinc2((j - 20) * pixel, pixel);
  });
  const auto off = test::difference(y, expected);
  // Interpolation between the far field's samples: 67 dB below what is near, as its window has it.
  EXPECT_LT(off.of_peak, 5e-4);
  EXPECT_LT(off.relative, 0.04);  // The worst of 1681 pixels, in a zero of the pattern.
}

class OneOpenSample : public testing::TestWithParam<std::array<int, 2>> {};

TEST_P(OneOpenSample, IsAFlatField) {
  const auto [width, height] = GetParam();
  Aperture pinhole{Image<float>(9, 7), 0.09};
  pinhole.transmittance(6, 2) = 1;
  const double p = pinhole.pixel_mm();
  const auto options =  // All that can be reached.
      test::absolute_xyz(width, height, 380e-6 / p / std::max(width, height));
  const GlareTemplate t = make_template(pinhole, *find_lamp("E"), options);
  const ColorMatchingFunctions& observer = color_matching_functions("cie1931-2deg");
  double expected = 0, luminance = 0;  // Of p^2 / lambda^2, over the lamp's wavelengths.
  for (double nm = 380.005; nm < 780; nm += 0.01) {
    luminance += observer.y_bar(nm);
    expected += observer.y_bar(nm) * p * p / (nm * nm * 1e-12);
  }
  for (const float y : t.channels[1].values())
    ASSERT_NEAR(y / (expected / luminance), 1, 1e-5);  // Single precision.
}

INSTANTIATE_TEST_SUITE_P(StraightEdges, OneOpenSample,
                         testing::Values(std::array{33, 21}, std::array{20, 20}, std::array{2, 9},
                                         std::array{3, 1}, std::array{1, 1}, std::array{2, 2}));

TEST(StraightEdges, TwoPinholesMakeYoungsFringes) {
  Aperture pinholes{Image<float>(64, 64), 0.64};
  pinholes.transmittance(12, 20) = 1;
  pinholes.transmittance(44, 36) = 1;  // 0.32 mm to the right and 0.16 mm down.
  const double pitch = 0.06 * kWavelength_mm / 0.32;
  const Image<float> y = test::luminance_of(pinholes, test::line_lamp(kWavelength_nm, 0.05),
                                            test::absolute_xyz(101, 101, pitch));
  const double p = pinholes.pixel_mm();
  const Image<float> expected = test::picture(101, 101, [&](int i, int j) {
    const double rx = 0.32 * pitch / kWavelength_mm, ry = 0.16 * pitch / kWavelength_mm;
    return p * p / (kWavelength_mm * kWavelength_mm) *
           (1 + sinc(rx) * sinc(ry) * std::cos(2 * kPi * (rx * (i - 50) + ry * (j - 50))));
  });
  EXPECT_LT(test::difference(y, expected).of_peak,
            1e-3);  // Interpolation: the band's edge, its worst.
}

TEST(StraightEdges, AGratingSendsEachWavelengthToItsSine) {
  constexpr double pitch_mm = 0.05;
  const Aperture grating = test::grating({1024, 256, 4}, pitch_mm);
  for (const double nm : {450.0, 550.0, 650.0}) {
    const double unit = nm * 1e-6 / pitch_mm;
    const Image<float> row =
        test::luminance_of(grating, test::line_lamp(nm), test::absolute_xyz(801, 1, unit / 300));
    for (const int side : {-1, 1}) {
      double sum = 0, moment = 0;
      for (int x = -80; x <= 80; ++x) {
        sum += row(400 + side * 300 + x, 0);
        moment += x * static_cast<double>(row(400 + side * 300 + x, 0));
      }
      EXPECT_NEAR(moment / sum / 300, 0, 1e-3) << nm;  // The envelope's slope under the spot.
      // Of half-open bars the first spots have sinc^2(1/2) = 0.405 of the middle's light; bars
      // drawn with pixels of 1 / 12.8 pitch, sinc^2(1 / 12.8) of that.
      double middle = 0;
      for (int x = -80; x <= 80; ++x) middle += row(400 + x, 0);
      const double expected = std::pow(sinc(0.5) * sinc(grating.pixel_mm() / pitch_mm), 2);
      EXPECT_NEAR(sum / middle, expected, 2e-3) << nm;  // Bars are few, 64: each spot has wings.
    }
  }
}

TEST(StraightEdges, AGratingsSpotHasTheColorOfItsWavelength) {
  const Aperture grating = test::grating({1024, 256, 4}, 0.05);
  const auto options = test::absolute_xyz(801, 1, 0.016 / 400);  // To 800 nm at the border.
  const GlareTemplate t = make_template(grating, *find_lamp("E"), options);
  const auto color = [&](int x) {
    return chromaticity({t.channels[0](x, 0), t.channels[1](x, 0), t.channels[2](x, 0)});
  };
  const auto& observer = color_matching_functions("cie1931-2deg");
  for (const int nm : {480, 520, 560, 620}) {
    const Chromaticity expected =
        chromaticity({observer.x_bar(nm), observer.y_bar(nm), observer.z_bar(nm)});
    const Chromaticity found = color(400 + nm / 2);
    EXPECT_NEAR(found.x, expected.x, 0.03) << nm;  // 64 bars: lines 8 nm wide, with faint wings.
    EXPECT_NEAR(found.y, expected.y, 0.03) << nm;
  }
}

}  // namespace
}  // namespace glare
