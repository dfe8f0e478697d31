// All light that gets through the aperture goes somewhere.

#include <gtest/gtest.h>

#include <cmath>

#include "glare/glare.h"
#include "support/templates.h"

namespace glare {
namespace {

/// The integral of the far field over one of its periods, 1 / pixel both ways.
double integral_over_period(const Aperture& aperture, double padding) {
  FarFieldRequest request;
  request.max_frequency_x_per_mm = request.max_frequency_y_per_mm = 0.5 / aperture.pixel_mm();
  request.padding = padding;
  const FarField f = far_field(aperture, request);
  const auto length = [&](double bin) {
    return static_cast<int>(std::lround(1 / (bin * aperture.pixel_mm())));
  };
  const int nx = length(f.bin_x_per_mm), ny = length(f.bin_y_per_mm);
  double sum = 0;
  for (int kx = 0; kx <= nx / 2; ++kx) {
    const double weight = kx == 0 || kx == nx / 2 ? 1 : 2;  // I(-f) = I(f).
    for (int ky = -ny / 2; ky < ny / 2; ++ky)
      sum += weight * f.intensity_mm2(ky - f.first_ky, kx - f.first_kx);
  }
  return sum * f.bin_x_per_mm * f.bin_y_per_mm;
}

TEST(Energy, TheFarFieldIntegratesToOne) {
  constexpr double kSinglePrecision = 3e-6;
  for (const double padding : {2.0, 4.0, 6.0}) {
    EXPECT_NEAR(integral_over_period(test::circle({256, 256, 4}, 3), padding), 1, kSinglePrecision);
    EXPECT_NEAR(integral_over_period(test::lopsided({301, 173, 7}), padding), 1, kSinglePrecision);
    EXPECT_NEAR(integral_over_period(test::grating({96, 200, 1}, 0.1), padding), 1,
                kSinglePrecision);
  }
}

/// The sum of the pixels' X, Y, Z times their solid angle.
Xyz all_light(const GlareTemplate& t) {
  Xyz sum{};
  for (std::size_t k = 0; k < 3; ++k)
    for (const float value : t.channels[k].values())
      sum[k] += value * t.pixel_pitch_rad * t.pixel_pitch_rad;
  return sum;
}

TEST(Energy, AFieldThatHoldsAllTheLightSumsToTheLampsColor) {
  // A pupil without an edge, exp(-r^2 / 2 s^2): its light keeps within a few lambda / s.
  const Aperture soft = test::sampled({128, 128, 4}, [](const test::Place& at) {
    return std::exp(-(at.x_mm * at.x_mm + at.y_mm * at.y_mm) / (2 * 0.4 * 0.4));
  });
  for (const char* name : {"A", "D65", "HP1", "FL11", "LED-RGB1", "E"}) {
    const GlareTemplate t =
        make_template(soft, *find_lamp(name), test::absolute_xyz(101, 101, 2e-5));
    const Xyz sum = all_light(t);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(sum[k], t.lamp_xyz[k], 1e-4 * (1 + t.lamp_xyz[k])) << name << ", " << k;
    EXPECT_NEAR(t.captured_energy, 1, 1e-4) << name;  // Interpolation and single precision.
  }
}

TEST(Energy, APupilsFieldAtItsReachHoldsAllButHalfAPercent) {
  // Of a circle's light, 0.2 / r lies beyond r lambda / D: here 0.3 % and less.
  const Aperture pupil = test::circle({320, 320, 3.2}, 3);
  for (const char* name : {"A", "HP5"}) {
    const auto options = test::absolute_xyz(320, 320, 380e-6 / 0.01 / 320);
    const GlareTemplate t = make_template(pupil, *find_lamp(name), options);
    const Xyz sum = all_light(t);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(sum[k] / t.lamp_xyz[k], 1, 5e-3) << name << ", " << k;
      RecordProperty(std::string(name) + std::to_string(k), std::to_string(sum[k] / t.lamp_xyz[k]));
    }
    EXPECT_LT(t.captured_energy, 1);
  }
}

TEST(Energy, TheCapturedShareIsTheSumOfThePixels) {
  for (const auto normalization :
       {Normalization::peak, Normalization::energy, Normalization::absolute}) {
    auto options = test::absolute_xyz(64, 48, 1e-4);
    options.normalization = normalization;
    options.color_space = lin_rec709_color_space();
    const GlareTemplate t =
        make_template(test::lashed_pupil({256, 256, 4}, 3), *find_lamp("C"), options);
    double sum = 0;
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 64; ++x) sum += t.luminance(x, y);
    const double share = sum * t.per_steradian * t.pixel_pitch_rad * t.pixel_pitch_rad;
    EXPECT_NEAR(share / t.captured_energy, 1, 1e-6) << to_string(normalization);
    EXPECT_GT(share, 0.5);
    EXPECT_LT(share, 1);
  }
}

}  // namespace
}  // namespace glare
