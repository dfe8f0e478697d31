// The template of the built-in eye does not depend on how finely the eye is drawn, right up to the
// field's rim.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "glare/glare.h"
#include "support/pixel_errors.h"
#include "support/templates.h"

namespace glare {
namespace {

/// Few lashes over a small pupil: quick, and as hard at the rim as a large one.
EyeParameters small_eye() {
  EyeParameters eye;
  eye.pupil.diameter_mm = 2.5;
  eye.eyelids.opening_mm = 3;
  return eye;
}

TemplateOptions options_for(double field_deg, int size) {
  TemplateOptions options = test::absolute_xyz(size, size, 1);
  options.field_of_view_deg = field_deg;
  return options;
}

WavelengthRange range_of(const Spectrum& lamp) { return effective_range(lamp, TemplateOptions{}); }

/// Relative differences of luminance, of all pixels and of those in the outermost eighth.
struct Differences {
  std::vector<double> all, rim;

  Differences(const Image<float>& a, const Image<float>& b) {
    const int rim_px = a.width() / 16;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) {
        const double difference = std::abs(a(x, y) - b(x, y)) / b(x, y);
        all.push_back(difference);
        const int from_rim = std::min({x, y, a.width() - 1 - x, a.height() - 1 - y});
        if (from_rim < rim_px) rim.push_back(difference);
      }
  }
};

constexpr double kField_deg = 5;
constexpr int kSize = 128;

Image<float> luminance(const Aperture& eye, const Spectrum& lamp) {
  return test::luminance_of(eye, lamp, options_for(kField_deg, kSize));
}

// The accuracy figure of docs/validation.md, for the 99th percentile of luminance. (The edges'
// light beyond the fine picture's reach, which its squares fold back, is what is left.)
constexpr double kPercentile99 = 0.01;

TEST(EyeResolution, TwiceThePixelsGiveTheSameTemplate) {
  const Spectrum lamp = *find_lamp("D65");
  const EyeParameters eye = small_eye();
  const Aperture drawn = draw_template_eye(eye, options_for(kField_deg, kSize), range_of(lamp));
  const Aperture twice =
      draw_template_eye(eye, options_for(2 * kField_deg, 2 * kSize), range_of(lamp));
  ASSERT_NEAR(twice.transmittance.width(), 2 * drawn.transmittance.width(), 1);
  const Differences off(luminance(drawn, lamp), luminance(twice, lamp));
  EXPECT_LT(test::percentile(off.all, 0.99), kPercentile99);
  EXPECT_LT(test::percentile(off.rim, 0.99), kPercentile99);
}

TEST(EyeResolution, TheTemplateIsThatOfAMuchFinerPictureDrawnByArea) {
  const Spectrum lamp = *find_lamp("D65");
  const EyeParameters eye = small_eye();
  const TemplateOptions options = options_for(kField_deg, kSize);
  const Aperture drawn = draw_template_eye(eye, options, range_of(lamp));
  const Aperture fine = draw_eye(eye, drawn.pixel_mm() / 6);
  const Differences off(luminance(drawn, lamp), luminance(fine, lamp));
  // A picture six times as fine is dimmed by its squares by up to 1 - sinc^2(0.385 / 6) = 1.4 % in
  // x and in y, at the corners by twice that, at 380 nm; for the eye's 555 nm a half of it.
  EXPECT_LT(test::percentile(off.all, 0.99), 0.02);
  EXPECT_LT(test::percentile(off.rim, 0.5), 0.014);
}

TEST(EyeResolution, TheEnergyIsTheDrawnEyes) {
  const WavelengthRange range = range_of(*find_lamp("D65"));
  EyeParameters clear = small_eye();
  for (MediumParticles* particles :
       {&clear.particles.cornea, &clear.particles.lens, &clear.particles.vitreous})
    particles->number_per_mm2 = 0;
  clear.lens.fibre_modulation = clear.lens.suture_contrast = 0;
  const Aperture drawn = draw_template_eye(clear, options_for(kField_deg, kSize), range);
  // Grey samples on the picture's edges have t^2 for t: the finer, the fewer.
  EXPECT_NEAR(energy_area_mm2(drawn), energy_area_mm2(draw_eye(clear, 0.001)),
              3e-3 * energy_area_mm2(drawn));
  EXPECT_NO_THROW(require_valid(drawn));
}

TEST(EyeResolution, TheEnergyDoesNotDependOnThePixels) {
  const WavelengthRange range = range_of(*find_lamp("D65"));
  const Aperture drawn = draw_template_eye(small_eye(), options_for(kField_deg, kSize), range);
  const Aperture twice =
      draw_template_eye(small_eye(), options_for(2 * kField_deg, 2 * kSize), range);
  // Particles that share a pixel without overlapping, or overlap, count the same.
  EXPECT_NEAR(energy_area_mm2(drawn), energy_area_mm2(twice), 5e-4 * energy_area_mm2(twice));
}

TEST(EyeResolution, TheEyeIsTheSameForAnyNumberOfThreads) {
  const Spectrum lamp = *find_lamp("D65");
  TemplateOptions options = options_for(2, 64);
  options.threads = 1;
  const Aperture one = draw_template_eye({}, options, range_of(lamp));
  options.threads = 2;
  const Aperture two = draw_template_eye({}, options, range_of(lamp));
  EXPECT_TRUE(std::ranges::equal(one.transmittance.values(), two.transmittance.values()));
  EXPECT_EQ(one.unlimited_energy_area_mm2, two.unlimited_energy_area_mm2);
}

TEST(EyeResolution, AClosedEyeIsRefused) {
  EyeParameters asleep;
  asleep.eyelids.share_above = 0;
  asleep.pupil.decentring_y_mm = -1;
  asleep.pupil.diameter_mm = 1;
  asleep.eyelids.opening_mm = 0.1;
  EXPECT_THROW(make_template(draw_eye(asleep, 0.01), *find_lamp("D65"), options_for(0.5, 16)),
               InputError);
}

}  // namespace
}  // namespace glare
