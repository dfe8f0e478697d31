#include "glare/io/photometry_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/image_file.h"
#include "support/scratch_folder.h"

namespace glare {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kIes = "IESNA91\nTILT=NONE\n1 -1 1 3 1 1 2 0 0 0\n1 1 50\n0 45 90\n0\n30 20 10\n";

std::string ldt_text() {
  std::string text = "Company\n1\n1\n1\n0\n3\n45\n";
  for (int line = 8; line <= 23; ++line) text += line < 13 ? "\n" : "1\n";
  text += "1\n0\n1\n1\nLamp\n2000\n\n\n55\n";
  for (int i = 0; i < 10; ++i) text += "0\n";
  return text + "0\n0\n45\n90\n30\n20\n10\n";
}

LuminousIntensityDistribution lamp_for_images() {
  Image<float> candela(11, 5);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 11; ++x) candela(x, y) = static_cast<float>(1000 * x + 0.1 * y);
  std::vector<double> h, v;
  for (int i = 0; i < 11; ++i) h.push_back(-50 + 10 * i);
  for (int j = 0; j < 5; ++j) v.push_back(-15 + 7.5 * j);
  return {PhotometricType::a, h, v, candela};
}

TEST(PhotometryFile, ToldByTheContentNotTheName) {
  const test::ScratchFolder folder;
  for (const char* name : {"a.ies", "a.ldt", "a.txt", "a"}) {
    test::set_file_text(folder / name, kIes);
    EXPECT_EQ(read_photometry(folder / name).info.format, "IES LM-63");
    test::set_file_text(folder / name, ldt_text());
    EXPECT_EQ(read_photometry(folder / name).info.format, "EULUMDAT");
    write_intensity_image(folder / name, lamp_for_images(), {{-50, 50}, {-15, 15}, 11, 5});
    EXPECT_EQ(read_photometry(folder / name).info.format, "image");
  }
}

TEST(PhotometryFile, ImagesComeBack) {
  const test::ScratchFolder folder;
  const auto lamp = lamp_for_images();
  const IntensityGrid grid{{-50, 50}, {-15, 15}, 11, 5};
  write_intensity_image(folder / "a.exr", lamp, grid);
  write_intensity_image(folder / "b.exr", lamp, grid);
  EXPECT_EQ(read_file(folder / "a.exr", 1e6), read_file(folder / "b.exr", 1e6));
  const auto data = read_photometry(folder / "a.exr");
  EXPECT_THAT(data.info.warnings, IsEmpty());
  EXPECT_EQ(data.distribution.type(), PhotometricType::a);
  EXPECT_EQ(data.distribution.horizontal_deg(), lamp.horizontal_deg());
  EXPECT_EQ(data.distribution.vertical_deg(), lamp.vertical_deg());
  for (const double h : lamp.horizontal_deg())
    for (const double v : lamp.vertical_deg())
      EXPECT_NEAR(data.distribution(h, v), lamp(h, v), 1e-3);  // 32-bit floats of 1e4 cd.
  // Ranges that are given count more than the file's.
  const auto other = read_photometry(folder / "a.exr", {.image_h_deg = {{0, 10}}});
  EXPECT_THAT(other.distribution.horizontal_deg(), testing::Contains(10));
  EXPECT_EQ(other.distribution.vertical_deg(), lamp.vertical_deg());
}

std::string pfm(int channels, const std::vector<float>& values) {
  std::string text = channels == 1 ? "Pf\n2 2\n-1.0\n" : "PF\n2 2\n-1.0\n";
  text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  return text;
}

const ReadPhotometryOptions kRanges{.image_h_deg = {{-50, 50}}, .image_v_deg = {{-15, 15}}};

TEST(PhotometryFile, ImagesOfOtherFormats) {
  const test::ScratchFolder folder;
  // PFM has the bottom row first.
  test::set_file_text(folder / "a.pfm", pfm(1, {1, 2, 3000, 4}));
  const auto data = read_photometry(folder / "a.pfm", kRanges);
  EXPECT_EQ(data.distribution(-50, -15), 1);
  EXPECT_EQ(data.distribution(50, -15), 2);
  EXPECT_EQ(data.distribution(-50, 15), 3000);
  test::set_file_text(folder / "dim.pfm", pfm(1, {0.1f, 0.2f, 0.3f, 0.4f}));
  EXPECT_EQ(read_photometry(folder / "dim.pfm", kRanges).distribution(50, 15), 0.4f);
  Image<float> values(3, 2, 0.5f);
  write_file_atomically(folder / "a.png", encode_png_gray16(values));
  EXPECT_THROW(read_photometry(folder / "a.png", kRanges), InputError);
  ReadPhotometryOptions options = kRanges;
  options.image_white_cd = 65535;
  EXPECT_EQ(read_photometry(folder / "a.png", options).distribution(0, 0), 32768);
}

template <typename Exception>
std::string refusal(const std::filesystem::path& path, const ReadPhotometryOptions& options = {}) {
  try {
    read_photometry(path, options);
  } catch (const Exception& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PhotometryFile, Refusals) {
  const test::ScratchFolder folder;
  const auto path = folder / "a.ies";
  EXPECT_THROW(read_photometry(path), InputError);
  test::set_file_text(path, "hello\n");
  EXPECT_THAT(refusal<InputError>(path), HasSubstr("a.ies:1: "));
  test::set_file_text(folder / "a.txt", "hello\n");
  EXPECT_THAT(refusal<InputError>(folder / "a.txt"), HasSubstr("neither"));
  test::set_file_text(path, std::string("IESNA91\0TILT=NONE\n", 18));
  EXPECT_THAT(refusal<InputError>(path), HasSubstr("no text"));
  test::set_file_text(path, kIes);
  EXPECT_THAT(refusal<OptionError>(path, kRanges), HasSubstr("is no image"));
  test::set_file_text(path, kIes + "7");
  EXPECT_THAT(refusal<InputError>(path), HasSubstr("a.ies:8: "));
  test::set_file_text(path, pfm(1, {1, 2, 3, 4}));
  EXPECT_THAT(refusal<OptionError>(path), HasSubstr("degrees of its first and last column"));
  EXPECT_THAT(refusal<OptionError>(path, {.image_h_deg = {{5, -5}}, .image_v_deg = {{-1, 1}}}),
              HasSubstr("ascending"));
  test::set_file_text(path, pfm(1, {1, 2, -3, 4}));
  EXPECT_THAT(refusal<InputError>(path, kRanges), HasSubstr("pixel (0, 0) is negative"));
  test::set_file_text(path, pfm(1, {1, 2, 3, std::nanf("")}));
  EXPECT_THAT(refusal<InputError>(path, kRanges), HasSubstr("not finite"));
  test::set_file_text(path, pfm(3, std::vector<float>(12, 5)));
  EXPECT_THAT(refusal<InputError>(path, kRanges), HasSubstr("3 channels"));
  ReadPhotometryOptions options = kRanges;
  options.image_white_cd = 0;
  test::set_file_text(path, pfm(1, {1, 2, 3, 4}));
  EXPECT_THROW(read_photometry(path, options), OptionError);
}

TEST(PhotometryFile, TiltFilesAreOfTheSameFolder) {
  const test::ScratchFolder folder;
  const auto inner = folder / "lamps";
  std::filesystem::create_directory(inner);
  test::set_file_text(inner / "lamp.tlt", "1\n2\n0 90\n1 0.5\n");
  test::set_file_text(folder / "lamp.tlt", "1\n2\n0 90\n1 0.7\n");
  const auto read = [&](const std::string& name) {
    std::string text = kIes;
    text.replace(text.find("NONE"), 4, name);
    test::set_file_text(inner / "a.ies", text);
    return read_photometry(inner / "a.ies").info;
  };
  EXPECT_THAT(read("lamp.tlt").tilt->multipliers, ElementsAre(1, 0.5));
  const std::string elsewhere = (folder / "lamp.tlt").string();
  for (const std::string& name :
       {std::string("../lamp.tlt"), std::string(".."), std::string("missing.tlt"),
        std::string("..\\lamp.tlt"), elsewhere}) {
    const auto info = read(name);
    EXPECT_FALSE(info.tilt.has_value()) << name;
    EXPECT_THAT(info.warnings, ElementsAre(HasSubstr("isn't read")));
  }
}

TEST(PhotometryFile, WritingIsAllOrNothing) {
  const test::ScratchFolder folder;
  const auto lamp = lamp_for_images();
  EXPECT_THROW(write_intensity_image(folder / "a.exr", lamp, {{-50, 50}, {-15, 15}, 1, 5}),
               OptionError);
  EXPECT_THROW(write_intensity_image(folder / "a.exr", lamp, {}, {}, 0, [](double) { return false; }),
               Cancelled);
  EXPECT_THROW(write_intensity_image(folder / "no" / "a.exr", lamp, {}), OutputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

}  // namespace
}  // namespace glare
