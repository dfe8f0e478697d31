#include "glare/template/make_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "glare/base/error.h"
#include "glare/spectrum/lamps.h"
#include "glare/spectrum/observer.h"
#include "glare/template/profile.h"
#include "support/templates.h"

namespace glare {
namespace {

const Aperture& pupil() { return test::small_pupil(); }
Spectrum lamp() { return *find_lamp("LED-B3"); }
TemplateOptions small() { return test::small_options(); }

GlareTemplate made(const TemplateOptions& options) {
  return make_template(pupil(), lamp(), options, "my lamp");
}

TEST(MakeTemplate, TellsWhatItIs) {
  auto options = small();
  options.wavelength_range_nm = {300, 700};
  options.observer = "cie2015-2deg";
  const GlareTemplate t = made(options);
  EXPECT_EQ(t.width(), 33);
  EXPECT_EQ(t.height(), 21);
  EXPECT_NEAR(t.pixel_pitch_deg(), 0.3 / 33, 1e-15);
  EXPECT_EQ(t.normalization, Normalization::peak);
  EXPECT_EQ(t.lamp, "my lamp");
  EXPECT_EQ(t.observer, "cie2015-2deg");
  EXPECT_EQ(t.wavelength_range_nm, (WavelengthRange{390, 700}));  // Where the observer begins.
  EXPECT_EQ(t.aperture_width_mm, 4);
  EXPECT_DOUBLE_EQ(t.aperture_area_mm2, energy_area_mm2(pupil()));
  EXPECT_EQ(t.lamp_xyz, xyz_from_spectrum(lamp(), color_matching_functions("cie2015-2deg"),
                                          t.wavelength_range_nm));
  EXPECT_THAT(t.software, testing::StartsWith("glare "));
  EXPECT_EQ(t.color_space.name(), "lin_rec709");
}

double sum_of_luminances(const GlareTemplate& t) {
  double sum = 0;
  for (int y = 0; y < t.height(); ++y)
    for (int x = 0; x < t.width(); ++x) sum += t.luminance(x, y);
  return sum;
}

TEST(MakeTemplate, NormalizationsDifferByTheirFactorToAbsolute) {
  auto options = small();
  options.normalization = Normalization::absolute;
  const GlareTemplate absolute = made(options);
  EXPECT_EQ(absolute.per_steradian, 1);
  options.normalization = Normalization::peak;
  const GlareTemplate peaked = made(options);
  EXPECT_NEAR(peak(peaked).luminance, 1, 1e-6);
  options.normalization = Normalization::energy;
  const GlareTemplate energy = made(options);
  EXPECT_NEAR(sum_of_luminances(energy), 1, 1e-6);
  for (const GlareTemplate* t : {&peaked, &energy}) {
    for (int k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 33 * 21; ++i)
        ASSERT_NEAR(t->channels[k].values()[i] * t->per_steradian, absolute.channels[k].values()[i],
                    1e-6 * peak(absolute).luminance);
    EXPECT_DOUBLE_EQ(t->captured_energy, absolute.captured_energy);
  }
}

TEST(MakeTemplate, RgbIsTheMatrixOfXyz) {
  auto options = small();
  options.normalization = Normalization::absolute;
  const GlareTemplate rgb = made(options);
  options.color_space = xyz_color_space();
  const GlareTemplate xyz = made(options);
  for (std::size_t i = 0; i < 33 * 21; ++i) {
    const Vector3 back = lin_rec709_color_space().xyz_from_rgb() *
                         Vector3{rgb.channels[0].values()[i], rgb.channels[1].values()[i],
                                 rgb.channels[2].values()[i]};
    for (int k = 0; k < 3; ++k)  // Single precision.
      ASSERT_NEAR(back[k] / xyz.channels[1].values()[i],
                  xyz.channels[k].values()[i] / xyz.channels[1].values()[i], 2e-6);
  }
}

TEST(MakeTemplate, AdaptedToTheLampAllItsLightIsWhite) {
  auto options = small();
  options.white = WhiteAdaptation::lamp;
  options.width = options.height = 129;  // Nearly all of the light.
  options.field_of_view_deg = 0.65;
  const GlareTemplate t = make_template(pupil(), *find_lamp("A"), options);
  const Chromaticity c = mean_chromaticity(t);
  EXPECT_NEAR(c.x, 0.3127, 2e-4);  // What lies outside is a little redder.
  EXPECT_NEAR(c.y, 0.3290, 2e-4);
  EXPECT_NEAR(t.lamp_xyz[0], 1.0985, 1e-3);  // The lamp's own colour stays told.
}

TEST(MakeTemplate, DesaturationLeavesNoNegativeChannelAndEveryLuminance) {
  const auto options = test::absolute_xyz(101, 3, 2e-5);
  auto keep = options, desaturate = options;
  keep.color_space = desaturate.color_space = lin_rec709_color_space();
  desaturate.gamut = GamutMapping::desaturate;
  const Aperture slit = test::slit({256, 64, 4}, 0.5);
  const GlareTemplate kept = make_template(slit, *find_lamp("LED-RGB1"), keep);
  const GlareTemplate mapped = make_template(slit, *find_lamp("LED-RGB1"), desaturate);
  bool outside = false;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 101; ++x) {
      EXPECT_NEAR(mapped.luminance(x, y) / kept.luminance(x, y), 1, 1e-5);  // Single precision.
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(mapped.channels[k](x, y), 0);
        outside = outside || kept.channels[k](x, y) < 0;
      }
    }
  EXPECT_TRUE(outside) << "the lamp is no test";
}

TEST(MakeTemplate, WithScatterItIsLessDiffractionAndStraylightInTheLampsColor) {
  auto options = test::absolute_xyz(33, 21, 1e-4);
  const GlareTemplate plain = made(options);
  options.scatter = Straylight{70, 1};
  const GlareTemplate whole = made(options);
  EXPECT_EQ(whole.scatter, options.scatter);
  EXPECT_EQ(whole.scattered_energy, scattered_energy({70, 1}));
  EXPECT_FALSE(plain.scatter.has_value());
  EXPECT_EQ(plain.scattered_energy, 0);
  for (const auto& [x, y] : {std::pair{16, 10}, {0, 0}, {30, 12}}) {
    const double angle_deg = std::asin(std::hypot(x - 16, y - 10) * 1e-4) * 180 / std::numbers::pi;
    const double s = straylight_per_steradian({70, 1}, angle_deg);
    for (std::size_t k = 0; k < 3; ++k)  // A point for a pixel's mean: S's bend over 1e-4.
      EXPECT_NEAR(whole.channels[k](x, y),
                  (1 - whole.scattered_energy) * plain.channels[k](x, y) + plain.lamp_xyz[k] * s,
                  2e-3 * plain.lamp_xyz[k] * s + 1e-6 * plain.channels[k](x, y));
  }
}

TEST(MakeTemplate, ScatterOutOfRangeIsRefusedInOneStepAndTwo) {
  auto options = small();
  const FarField field = template_far_field(pupil(), options, effective_range(lamp(), options));
  options.scatter = Straylight{101, 0.5};
  EXPECT_THROW(made(options), OptionError);
  EXPECT_THROW(make_template(field, lamp(), options), OptionError);
  options.scatter = Straylight{30, -0.5};
  EXPECT_THROW(template_far_field(pupil(), options, effective_range(lamp(), options)), OptionError);
}

TEST(MakeTemplate, InTwoStepsScatterIsTheSame) {
  auto options = small();
  options.scatter = Straylight{24, 0.5};
  const GlareTemplate one = made(options);
  const FarField field = template_far_field(pupil(), options, effective_range(lamp(), options));
  const GlareTemplate two = make_template(field, lamp(), options);
  for (std::size_t i = 0; i < 33 * 21; ++i)
    ASSERT_EQ(one.channels[1].values()[i], two.channels[1].values()[i]);
}

}  // namespace
}  // namespace glare
