#include "glare/io/template_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "glare/base/error.h"
#include "support/scratch_folder.h"
#include "support/templates.h"

namespace glare {
namespace {

using testing::HasSubstr;

// A number kept as a 32-bit float.
constexpr double kSinglePrecision = 6e-8;

TemplateFileOptions with_threads(int threads) {
  TemplateFileOptions options;
  options.threads = threads;
  return options;
}

const TemplateFileOptions kHalf = [] {
  TemplateFileOptions options;
  options.half = true;
  return options;
}();

GlareTemplate sample() {
  GlareTemplate t;
  for (int k = 0; k < 3; ++k)
    t.channels[k] = test::picture(
        7, 5, [&](int x, int y) { return std::exp(-x - 2.3 * y) - 1e-3 * k * x + k; });
  t.pixel_pitch_rad = 1.7e-4;
  t.normalization = Normalization::energy;
  t.per_steradian = 3.21e5;
  t.captured_energy = 0.87;
  t.lamp_xyz = {1.09, 1, 0.35};
  t.lamp = "my lamp.csv";
  t.observer = "cie1964-10deg";
  t.wavelength_range_nm = {390.5, 781};
  t.aperture_width_mm = 8.125;
  t.aperture_area_mm2 = 12.5;
  t.recipe = "glare template \xC3\xA9\nsha256 of everything";
  t.software = "glare 9.9";
  return t;
}

void expect_same_pixels(const GlareTemplate& a, const GlareTemplate& b) {
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(a.channels[k].width(), b.channels[k].width());
    EXPECT_TRUE(std::ranges::equal(a.channels[k].values(), b.channels[k].values())) << k;
  }
}

TEST(TemplateFile, EveryFieldComesBack) {
  const test::ScratchFolder folder;
  const GlareTemplate t = sample();
  write_template(folder / "t.exr", t);
  const GlareTemplate back = read_template(folder / "t.exr");
  expect_same_pixels(back, t);
  EXPECT_NEAR(back.pixel_pitch_rad / t.pixel_pitch_rad, 1, kSinglePrecision);
  EXPECT_EQ(back.normalization, t.normalization);
  EXPECT_NEAR(back.per_steradian / t.per_steradian, 1, kSinglePrecision);
  EXPECT_NEAR(back.captured_energy / t.captured_energy, 1, kSinglePrecision);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(back.lamp_xyz[k] / t.lamp_xyz[k], 1, kSinglePrecision);
  EXPECT_EQ(back.lamp, t.lamp);
  EXPECT_EQ(back.observer, t.observer);
  EXPECT_EQ(back.wavelength_range_nm, t.wavelength_range_nm);
  EXPECT_EQ(back.aperture_width_mm, t.aperture_width_mm);
  EXPECT_EQ(back.aperture_area_mm2, t.aperture_area_mm2);
  EXPECT_EQ(back.recipe, t.recipe);
  EXPECT_EQ(back.software, t.software);
  EXPECT_EQ(back.color_space.name(), "lin_rec709");
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_NEAR(back.color_space.rgb_from_xyz()[row][column],
                  t.color_space.rgb_from_xyz()[row][column], 1e-6);  // Through chromaticities.
}

TEST(TemplateFile, XyzComesBackExactly) {
  const test::ScratchFolder folder;
  GlareTemplate t = sample();
  t.color_space = xyz_color_space();
  write_template(folder / "t.exr", t);
  const GlareTemplate back = read_template(folder / "t.exr");
  expect_same_pixels(back, t);
  EXPECT_TRUE(back.color_space.is_xyz());
}

std::map<std::string, std::string> header_of(const std::filesystem::path& path) {
  std::map<std::string, std::string> out;
  for (const HeaderAttribute& a : read_header(path)) out[a.name] = a.type + " " + a.value;
  return out;
}

TEST(TemplateFile, TheHeaderIsTheContracts) {
  const test::ScratchFolder folder;
  write_template(folder / "t.exr", sample());
  auto header = header_of(folder / "t.exr");
  EXPECT_EQ(header["glare:formatVersion"], "int 1");
  EXPECT_THAT(header["glare:pixelPitch_deg"], HasSubstr("float 0.00974028"));
  EXPECT_EQ(header["glare:center_px"], "v2f 3 2");
  EXPECT_EQ(header["glare:normalization"], "string energy");
  EXPECT_EQ(header["glare:wavelengthRange_nm"], "v2f 390.5 781");
  EXPECT_THAT(header["chromaticities"], HasSubstr("chromaticities 0.6399"));
  EXPECT_THAT(header["channel R"], HasSubstr("float"));
  GlareTemplate xyz = sample();
  xyz.color_space = xyz_color_space();
  write_template(folder / "t.exr", xyz, kHalf);
  header = header_of(folder / "t.exr");
  EXPECT_FALSE(header.contains("chromaticities"));
  EXPECT_THAT(header["channel X"], HasSubstr("half"));
}

TEST(TemplateFile, HalfIsRoundedAndRefusesWhatItCannotHold) {
  const test::ScratchFolder folder;
  GlareTemplate t = sample();
  t.channels[1](3, 2) = -65504;
  write_template(folder / "t.exr", t, kHalf);
  const GlareTemplate back = read_template(folder / "t.exr");
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < t.channels[k].values().size(); ++i) {
      const float expected = t.channels[k].values()[i];  // 11 bits, and 2^-24 at the least.
      EXPECT_NEAR(back.channels[k].values()[i], expected, std::abs(expected) / 2048 + 3e-8);
    }
  const std::string before = test::file_text(folder / "t.exr");
  for (const float value : {65505.0f, -7e4f}) {
    t.channels[1](3, 2) = value;
    EXPECT_THROW(write_template(folder / "t.exr", t, kHalf), OptionError) << value;
  }
  EXPECT_EQ(test::file_text(folder / "t.exr"), before);
}

TEST(TemplateFile, TheSameTemplateGivesTheSameBytes) {
  const test::ScratchFolder folder;
  GlareTemplate t = sample();
  for (auto& channel : t.channels)  // Some blocks of 16 rows for the compression's threads.
    channel = test::picture(60, 200, [](int x, int y) { return std::sin(x * y); });
  write_template(folder / "a.exr", t, with_threads(1));
  write_template(folder / "b.exr", t, with_threads(3));
  EXPECT_EQ(test::file_text(folder / "a.exr"), test::file_text(folder / "b.exr"));
}

TEST(TemplateFile, CancellingLeavesNothing) {
  const test::ScratchFolder folder;
  TemplateFileOptions options;
  options.keep_going = [] { return false; };
  EXPECT_THROW(write_template(folder / "t.exr", sample(), options), Cancelled);
  EXPECT_FALSE(std::filesystem::exists(folder / "t.exr"));
}

TEST(TemplateFile, WhereNoFileCanBeWrittenIsTold) {
  const test::ScratchFolder folder;
  EXPECT_THROW(write_template((folder / "none") / "t.exr", sample()), OutputError);
}

}  // namespace
}  // namespace glare
