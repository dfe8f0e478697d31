// Files that aren't templates, or aren't quite.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/template_file.h"
#include "support/scratch_folder.h"
#include "support/templates.h"

namespace glare {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

GlareTemplate sample() {
  GlareTemplate t;
  t.channels.fill(test::picture(40, 30, [](int x, int y) { return x * y * 0.1; }));
  t.pixel_pitch_rad = 1e-4;
  t.per_steradian = 1e5;
  t.lamp = "LAMP";
  t.aperture_width_mm = t.aperture_area_mm2 = 8;
  return t;
}

class TemplateFileRefusal : public testing::Test {
 protected:
  TemplateFileRefusal() {
    write_template(path_, sample());
    bytes_ = test::file_text(path_);
  }

  /// The error's message after one part of the file is another of the same length.
  std::string refusal_after(const std::string& part, const std::string& other) const {
    std::string bytes = bytes_;
    const auto place = bytes.find(part);
    EXPECT_NE(place, std::string::npos) << part;
    EXPECT_EQ(part.size(), other.size());
    return refusal_of(bytes.replace(place, part.size(), other));
  }

  std::string refusal_of(const std::string& bytes) const {
    test::set_file_text(path_, bytes);
    try {
      read_template(path_);
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), path_.string());
      EXPECT_THAT(error.what(), StartsWith(path_.string() + ": "));
      return error.what();
    }
    return "(was accepted)";
  }

  test::ScratchFolder folder_;
  std::filesystem::path path_ = folder_ / "t.exr";
  std::string bytes_;
};

struct Attribute {
  const char* name;
  const char* type;
};

constexpr Attribute kAttributes[] = {{"chromaticities", "chromaticities"},
                                     {"glare:formatVersion", "int"},
                                     {"glare:pixelPitch_deg", "float"},
                                     {"glare:center_px", "v2f"},
                                     {"glare:colorSpace", "string"},
                                     {"glare:normalization", "string"},
                                     {"glare:perSteradian", "float"},
                                     {"glare:capturedEnergy", "float"},
                                     {"glare:lampXYZ", "v3f"},
                                     {"glare:lamp", "string"},
                                     {"glare:observer", "string"},
                                     {"glare:wavelengthRange_nm", "v2f"},
                                     {"glare:apertureWidth_mm", "float"},
                                     {"glare:apertureArea_mm2", "float"},
                                     {"glare:recipe", "string"},
                                     {"glare:software", "string"}};

/// As they stand in the file: two texts that end with a zero.
std::string entry(const std::string& name, const std::string& type) {
  return name + '\0' + type + '\0';
}

TEST_F(TemplateFileRefusal, EachAttributeIsNeededAndNamedWhereItIsMissing) {
  for (const Attribute& a : kAttributes) {
    std::string other = a.name;
    other[1] = 'X';
    EXPECT_THAT(refusal_after(entry(a.name, a.type), entry(other, a.type)),
                HasSubstr("the attribute " + std::string(a.name) + " is missing"));
  }
}

TEST_F(TemplateFileRefusal, AnAttributeOfAnotherTypeIsNamed) {
  for (const Attribute& a : kAttributes) {
    std::string other = a.type;
    other[0] = 'Q';  // A type unknown to OpenEXR.
    EXPECT_THAT(refusal_after(entry(a.name, a.type), entry(a.name, other)),
                HasSubstr("the attribute " + std::string(a.name) + " is of another type"));
  }
}

/// A number as the file holds it, after its size in bytes.
template <typename Number>
std::string value(Number number) {
  const char size[4] = {sizeof number, 0, 0, 0};
  return std::string(size, 4) + std::string(reinterpret_cast<const char*>(&number), sizeof number);
}

TEST_F(TemplateFileRefusal, ImpossibleValues) {
  const std::string width = entry("glare:apertureWidth_mm", "float");
  for (const float number : {0.0f, -8.0f, HUGE_VALF, std::nanf("")})
    EXPECT_THAT(refusal_after(width + value(8.0f), width + value(number)),
                HasSubstr("glare:apertureWidth_mm"))
        << number;
  const std::string version = entry("glare:formatVersion", "int");
  EXPECT_THAT(refusal_after(version + value(1), version + value(2)), HasSubstr("version 1"));
  const std::string center = entry("glare:center_px", "v2f") + std::string("\x08\0\0\0", 4);
  EXPECT_THAT(refusal_after(center + value(20.0f).substr(4), center + value(19.5f).substr(4)),
              HasSubstr("glare:center_px"));
  EXPECT_THAT(refusal_after("peak", "pork"), HasSubstr("pork"));
}

TEST_F(TemplateFileRefusal, StraylightThatIsNotWholeOrImpossible) {
  GlareTemplate t = sample();
  t.scatter = Straylight{24, 0.5};
  t.scattered_energy = 0.75;
  write_template(path_, t);
  bytes_ = test::file_text(path_);
  EXPECT_THAT(refusal_after("cie146", "cie147"), HasSubstr("cie147"));
  const std::pair<std::string, float> numbers[] = {{"glare:scatterAge_years", 24.0f},
                                                   {"glare:scatterPigment", 0.5f},
                                                   {"glare:scatteredEnergy", 0.75f}};
  for (const auto& [name, number] : numbers) {
    std::string other = name;
    other[1] = 'X';
    EXPECT_THAT(refusal_after(entry(name, "float"), entry(other, "float")), HasSubstr(name));
    for (const float bad : {-0.5f, 100.5f, HUGE_VALF, std::nanf("")})
      EXPECT_THAT(
          refusal_after(entry(name, "float") + value(number), entry(name, "float") + value(bad)),
          HasSubstr(name))
          << bad;
  }
}

TEST_F(TemplateFileRefusal, AMissingChannelIsNamed) {
  const std::string list = entry("channels", "chlist");
  const auto red = bytes_.find(std::string("R\0\2\0\0\0", 6), bytes_.find(list));
  ASSERT_NE(red, std::string::npos);
  std::string bytes = bytes_;
  bytes[red] = 'S';
  EXPECT_THAT(refusal_of(bytes), HasSubstr("has no channel R"));
}

TEST_F(TemplateFileRefusal, WhatIsNoOpenExrAtAll) {
  EXPECT_THAT(refusal_of(""), HasSubstr("not an OpenEXR file"));
  EXPECT_THAT(refusal_of("P5 1 1 255 x"), HasSubstr("not an OpenEXR file"));
  std::filesystem::remove(path_);
  EXPECT_THROW(read_template(path_), InputError);
  EXPECT_THROW(read_header(path_), InputError);
  EXPECT_THROW(read_template(folder_ / "."), InputError);
}

TEST_F(TemplateFileRefusal, AFileCutAnywhere) {
  for (std::size_t size = 0; size < bytes_.size(); size += 1 + size / 7)
    EXPECT_NE(refusal_of(bytes_.substr(0, size)), "(was accepted)") << size;
  EXPECT_NE(refusal_of(bytes_.substr(0, bytes_.size() - 1)), "(was accepted)");
}

TEST_F(TemplateFileRefusal, ADamagedByteNeverDoesWorse) {
  for (std::size_t i = 0; i < bytes_.size(); i += 13) {
    std::string bytes = bytes_;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x55);
    test::set_file_text(path_, bytes);
    try {
      read_template(path_);  // A byte of the recipe, say, does no harm.
    } catch (const InputError&) {
    }
  }
}

}  // namespace
}  // namespace glare
