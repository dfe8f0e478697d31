#include "glare/io/template_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "glare/base/error.h"
#include "glare/io/color_config.h"
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
  t.light_xyz = {0.95, 1, 1.1};
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
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(back.light_xyz[k] / t.light_xyz[k], 1, kSinglePrecision);
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

TEST(TemplateFile, WithoutTheLightsColorItIsTheLamps) {
  const test::ScratchFolder folder;
  write_template(folder / "t.exr", sample());
  std::string bytes = test::file_text(folder / "t.exr");
  bytes.replace(bytes.find("glare:lightXYZ"), 14, "glare:otherXYZ");
  test::set_file_text(folder / "t.exr", bytes);
  const GlareTemplate back = read_template(folder / "t.exr");
  EXPECT_EQ(back.light_xyz, back.lamp_xyz);
  EXPECT_NEAR(back.light_xyz[0], 1.09, kSinglePrecision);
}

TEST(TemplateFile, StraylightComesBackAndIsWrittenOnlyWhereThereIsAny) {
  const test::ScratchFolder folder;
  GlareTemplate t = sample();
  write_template(folder / "t.exr", t);
  EXPECT_FALSE(read_template(folder / "t.exr").scatter.has_value());
  for (const HeaderAttribute& a : read_header(folder / "t.exr"))
    EXPECT_FALSE(a.name.starts_with("glare:scatter")) << a.name;
  t.scattered_energy = 0.625;
  // 1.2 isn't a 32-bit float; the limit is kept all the same.
  for (const Straylight eye : {Straylight{0, 0}, Straylight{24, 0.5}, Straylight{100, 1.2}}) {
    t.scatter = eye;
    write_template(folder / "t.exr", t);
    const GlareTemplate back = read_template(folder / "t.exr");
    EXPECT_EQ(back.scatter, eye);
    EXPECT_EQ(back.scattered_energy, 0.625);
  }
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

TEST(TemplateFile, LuminanceIsTheSameAfterReading) {
  const test::ScratchFolder folder;
  GlareTemplate t = sample();
  for (const char* name :
       {"xyz", "lin_rec709", "lin_rec2020", "lin_p3d65", "acescg", "aces2065-1", "ntsc1953"}) {
    t.color_space = find_color_space(name);
    write_template(folder / "t.exr", t);
    const GlareTemplate back = read_template(folder / "t.exr");
    EXPECT_EQ(back.color_space.name(), name);
    for (int k = 0; k < 3; ++k)  // Chromaticities are 32-bit floats.
      EXPECT_NEAR(back.color_space.xyz_from_rgb()[1][k], t.color_space.xyz_from_rgb()[1][k], 1e-6)
          << name;
  }
}

TEST(TemplateFile, OneReadingGivesTheTemplateAndTheHeader) {
  const test::ScratchFolder folder;
  write_template(folder / "t.exr", sample());
  const TemplateFile file = read_template_file(folder / "t.exr");
  expect_same_pixels(file.glare_template, sample());
  EXPECT_EQ(file.glare_template.lamp, "my lamp.csv");
  const auto header = read_header(folder / "t.exr");
  ASSERT_EQ(file.header.size(), header.size());
  for (std::size_t i = 0; i < header.size(); ++i) {
    EXPECT_EQ(file.header[i].name, header[i].name);
    EXPECT_EQ(file.header[i].value, header[i].value);
  }
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
  EXPECT_THAT(header["chromaticities"], HasSubstr("chromaticities 0.64 0.33 0.3 0.6 "));
  EXPECT_THAT(header["channel R"], HasSubstr("float"));
  EXPECT_EQ(header["channels"], "chlist B float, G float, R float");
  EXPECT_EQ(header["compression"], "compression zip");
  EXPECT_EQ(header["dataWindow"], "box2i 0 0 6 4");
  EXPECT_EQ(header["displayWindow"], "box2i 0 0 6 4");
  EXPECT_EQ(header["lineOrder"], "lineOrder increasing y");
  EXPECT_EQ(header["pixelAspectRatio"], "float 1");
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

/// More rows than are encoded at once.
GlareTemplate tall_sample() {
  GlareTemplate t = sample();
  for (int k = 0; k < 3; ++k)
    t.channels[k] = test::picture(9, 1000, [&](int x, int y) { return std::sin(k + x + 9 * y); });
  return t;
}

TEST(TemplateFile, EncodingCanBeStopped) {
  const test::ScratchFolder folder;
  int asked = 0;
  TemplateFileOptions options;
  options.keep_going = [&] { return ++asked < 3; };
  EXPECT_THROW(write_template(folder / "t.exr", tall_sample(), options), Cancelled);
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
  asked = 0;
  options.keep_going = [&] { return ++asked > 0; };
  write_template(folder / "t.exr", tall_sample(), options);
  EXPECT_GE(asked, 1000 / 256);
}

TEST(TemplateFile, TallPicturesAreWholeInFloatAndHalf) {
  const test::ScratchFolder folder;
  const GlareTemplate t = tall_sample();
  write_template(folder / "t.exr", t);
  expect_same_pixels(read_template(folder / "t.exr"), t);
  write_template(folder / "h.exr", t, kHalf);
  const GlareTemplate back = read_template(folder / "h.exr");
  for (int k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < t.channels[k].values().size(); ++i)
      ASSERT_NEAR(back.channels[k].values()[i], t.channels[k].values()[i], 1.0 / 4096);  // 11 bits.
}

TEST(TemplateFile, SeveralThreadsCanWriteAtOnce) {
  const test::ScratchFolder folder;
  const GlareTemplate t = tall_sample();
  write_template(folder / "alone.exr", t);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back(
        [&, i] { write_template(folder / (std::to_string(i) + ".exr"), t, with_threads(i)); });
  for (std::thread& thread : threads) thread.join();
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(test::file_text(folder / (std::to_string(i) + ".exr")),
              test::file_text(folder / "alone.exr"));
}

/// Runs with files of at most that many bytes.
template <typename Work>
void with_file_size_limit(rlim_t bytes, const Work& work) {
  struct rlimit old_limit {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  struct rlimit limit = old_limit;
  limit.rlim_cur = bytes;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  work();
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);
}

TEST(TemplateFile, AFullDiskIsAnErrorAndLeavesTheOldFile) {
  const test::ScratchFolder folder;
  GlareTemplate t = tall_sample();  // Large enough to be written in several pieces.
  for (auto& channel : t.channels)
    channel = test::picture(600, 700, [](int x, int y) { return std::sin(x * y * 0.7); });
  write_template(folder / "whole.exr", t);
  const auto size = std::filesystem::file_size(folder / "whole.exr");
  ASSERT_GT(size, 1'000'000u);
  test::set_file_text(folder / "t.exr", "old");
  for (const rlim_t limit : {rlim_t{0}, rlim_t{100}, rlim_t{300'000}, rlim_t{size / 2}, size - 1})
    with_file_size_limit(
        limit, [&] { EXPECT_THROW(write_template(folder / "t.exr", t), OutputError) << limit; });
  EXPECT_EQ(test::file_text(folder / "t.exr"), "old");
  const auto entries = std::filesystem::directory_iterator(folder / ".");
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 2);
  with_file_size_limit(size, [&] { write_template(folder / "t.exr", t); });
  EXPECT_EQ(test::file_text(folder / "t.exr"), test::file_text(folder / "whole.exr"));
}

TEST(TemplateFile, WhereNoFileCanBeWrittenIsTold) {
  const test::ScratchFolder folder;
  EXPECT_THROW(write_template((folder / "none") / "t.exr", sample()), OutputError);
}

}  // namespace
}  // namespace glare
