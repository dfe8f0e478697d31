// Templates in two steps: one far field for many lamps, observers and colour spaces.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "glare/base/error.h"
#include "glare/spectrum/lamps.h"
#include "glare/template/make_template.h"
#include "support/templates.h"

namespace glare {
namespace {

const Aperture& pupil() { return test::small_pupil(); }
Spectrum lamp() { return *find_lamp("LED-B3"); }
TemplateOptions small() { return test::small_options(); }
Spectrum table(double lo_nm, double hi_nm) { return {{lo_nm, hi_nm}, {1, 2}}; }

void expect_same(const GlareTemplate& a, const GlareTemplate& b, const std::string& what) {
  for (int k = 0; k < 3; ++k)
    EXPECT_TRUE(std::ranges::equal(a.channels[k].values(), b.channels[k].values())) << what;
  EXPECT_EQ(a.per_steradian, b.per_steradian) << what;
  EXPECT_EQ(a.captured_energy, b.captured_energy) << what;
  EXPECT_EQ(a.lamp_xyz, b.lamp_xyz) << what;
  EXPECT_EQ(a.wavelength_range_nm, b.wavelength_range_nm) << what;
  EXPECT_EQ(a.aperture_width_mm, b.aperture_width_mm) << what;
  EXPECT_EQ(a.aperture_area_mm2, b.aperture_area_mm2) << what;
}

TEST(TemplateFarField, ServesManyLampsToTheLastBit) {
  const auto options = small();
  const FarField field = template_far_field(pupil(), options, options.wavelength_range_nm);
  for (const char* name : {"D65", "HP1", "blackbody:3200"}) {
    const Spectrum other = *find_lamp(name);
    expect_same(make_template(field, other, options), make_template(pupil(), other, options), name);
  }
}

TEST(TemplateFarField, ServesOtherOptionsToTheLastBit) {
  const FarField field = template_far_field(pupil(), small(), small().wavelength_range_nm);
  std::vector<TemplateOptions> changed(5, small());
  changed[0].observer = "cie1964-10deg";
  changed[1].color_space = xyz_color_space();
  changed[2].white = WhiteAdaptation::lamp;
  changed[3].normalization = Normalization::absolute;
  changed[4].gamut = GamutMapping::desaturate;
  for (const TemplateOptions& options : changed)
    expect_same(make_template(field, lamp(), options), make_template(pupil(), lamp(), options), "");
}

TEST(TemplateFarField, ServesEverythingWithinItsRange) {
  const FarField field = template_far_field(pupil(), small(), {380, 780});
  auto options = small();
  options.observer = "cie2015-2deg";  // From 390 nm.
  for (const Spectrum& other : {lamp(), table(420, 700)}) {
    const GlareTemplate two_steps = make_template(field, other, options);
    const GlareTemplate one_step = make_template(pupil(), other, options);
    for (int k = 0; k < 3; ++k)  // The same samples at the most: what is left is rounding.
      EXPECT_LT(test::difference(two_steps.channels[k], one_step.channels[k]).of_peak, 1e-5);
  }
  const FarField narrow = template_far_field(pupil(), small(), {500, 780});
  EXPECT_THROW(make_template(narrow, lamp(), small()), OptionError);
}

TEST(TemplateFarField, TheRangeOfSeveralLampsHoldsEach) {
  const std::vector<Spectrum> lamps = {table(450, 600), table(420, 500), table(430, 900)};
  EXPECT_EQ(effective_range(lamps, small()), (WavelengthRange{420, 780}));
  EXPECT_EQ(effective_range(std::span(lamps).first(1), small()), (WavelengthRange{450, 600}));
  const FarField field = template_far_field(pupil(), small(), effective_range(lamps, small()));
  for (const Spectrum& each : lamps) EXPECT_NO_THROW(make_template(field, each, small()));
  EXPECT_THROW(effective_range(std::span<const Spectrum>(), small()), InputError);
  EXPECT_THROW(effective_range(std::vector{lamp(), table(900, 1000)}, small()), InputError);
}

TEST(TemplateFarField, IsTheSameForRangesThatBeginTogether) {
  const WavelengthRange whole{380, 780}, shorter{380, 600}, later{400, 780};
  const FarField field = template_far_field(pupil(), small(), whole);
  EXPECT_TRUE(same_far_field(field, small(), whole, whole));
  EXPECT_TRUE(same_far_field(field, small(), whole, shorter));
  EXPECT_FALSE(same_far_field(field, small(), whole, later));
  const FarField other = template_far_field(pupil(), small(), shorter);
  EXPECT_TRUE(std::ranges::equal(field.intensity_mm2.values(), other.intensity_mm2.values()));
  expect_same(make_template(field, table(380, 600), small()),
              make_template(pupil(), table(380, 600), small()), "the shorter");
}

/// The samples follow from how many cycles of the pattern's finest detail a pixel is at the longest
/// wavelength: there are widths of pixels for which two ranges that begin together differ.
TEST(TemplateFarField, IsAnotherWhereALongerWavelengthNeedsFinerSamples) {
  const WavelengthRange whole{380, 780}, shorter{380, 600};
  int different = 0;
  for (double deg = 0.1; deg < 0.6; deg *= 1.05) {
    auto options = small();
    options.width = options.height = 9;
    options.field_of_view_deg = deg;
    const FarField a = template_far_field(pupil(), options, whole);
    const FarField b = template_far_field(pupil(), options, shorter);
    const bool same = std::ranges::equal(a.intensity_mm2.values(), b.intensity_mm2.values());
    EXPECT_EQ(same_far_field(a, options, whole, shorter), same) << deg;
    different += !same;
  }
  EXPECT_GT(different, 0);
}

TEST(TemplateFarField, WhatIsImpossibleIsToldBefore) {
  auto options = small();
  EXPECT_NO_THROW(require_far_field_possible(pupil(), options, {380, 780}));
  EXPECT_THROW(require_far_field_possible(Aperture{Image<float>(8, 8), 1}, options, {380, 780}),
               InputError);
  options.field_of_view_deg = 3;
  EXPECT_THROW(require_far_field_possible(pupil(), options, {380, 780}), OptionError);
  options = small();
  options.memory_limit_bytes = 100'000;
  EXPECT_THROW(require_far_field_possible(pupil(), options, {380, 780}), MemoryError);
}

TEST(TemplateFarField, WhatTheCallerTakesBesideCounts) {
  auto options = small();
  const ApertureSize size{128, 128, pupil().pixel_mm()};
  options.memory_limit_bytes = template_bytes(size, options, options.wavelength_range_nm);
  EXPECT_NO_THROW(require_memory(size, options, options.wavelength_range_nm));
  options.further_bytes = 1;
  EXPECT_EQ(template_bytes(size, options, options.wavelength_range_nm),
            options.memory_limit_bytes + 1);
  EXPECT_THROW(require_memory(size, options, options.wavelength_range_nm), MemoryError);
}

}  // namespace
}  // namespace glare
