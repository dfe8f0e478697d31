#include "glare/photometry/ies_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glare/base/error.h"
#include "glare/photometry/beam.h"

namespace glare {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

/// A type C file of 3 gammas and as many planes as there are rows.
std::string type_c(const std::string& planes, const std::string& rows,
                   const std::string& version = "IESNA:LM-63-2002\n") {
  const auto count = 1 + std::count(planes.begin(), planes.end(), ' ');
  return version + "[TEST] 1\nTILT=NONE\n1 1000 2 3 " + std::to_string(count) +
         " 1 2 0.1 0.2 0.3\n1 1 50\n0 45 90\n" + planes + "\n" + rows;
}

const std::string kRotational = type_c("0", "30 20 10\n");

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(IesText, ReadsWhatTheFileTells) {
  const PhotometricData data = parse_ies(
      "IESNA:LM-63-1995\r\n[TEST] ABC 12\r\n[manufac] Caf\xE9 \x01 Lux\r\n[MORE]  & Co\r\n"
      "[_ABSOLUTELUMENS] 532\r\nTILT=NONE\r\n"
      "2 1500 1.5 3 2 1 1 1 2 -3\r\n0.9 1 63.7\r\n0 45 90\r\n0 90\r\n10 20 30\r\n40 50 60\r\n",
      "a.ies");
  EXPECT_EQ(data.info.format, "IES LM-63");
  EXPECT_EQ(data.info.version, "IESNA:LM-63-1995");
  EXPECT_EQ(data.info.symmetry, PhotometricSymmetry::quadrants);
  EXPECT_EQ(data.info.lamp_count, 2);
  EXPECT_EQ(data.info.lamp_flux_lm, 3000);
  EXPECT_EQ(data.info.stated_flux_lm, 532);
  EXPECT_FALSE(data.info.absolute_photometry);
  EXPECT_EQ(data.info.input_watts, 63.7);
  EXPECT_DOUBLE_EQ(data.info.intensity_factor, 1.35);
  EXPECT_THAT(data.info.luminous_size_m,
              ElementsAre(testing::DoubleEq(0.3048), testing::DoubleEq(0.6096),
                          testing::DoubleEq(-0.9144)));
  ASSERT_THAT(data.info.keywords, SizeIs(3));
  EXPECT_EQ(data.info.keywords[0], std::pair(std::string("TEST"), std::string("ABC 12")));
  EXPECT_EQ(data.info.keywords[1],
            std::pair(std::string("MANUFAC"), std::string("Caf\xC3\xA9   Lux & Co")));
  EXPECT_THAT(data.info.warnings, IsEmpty());
  EXPECT_EQ(data.distribution.type(), PhotometricType::c);
  EXPECT_FLOAT_EQ(static_cast<float>(data.distribution(0, 45)), 27);
}

/// What each of these texts stands for.
void expect_rotational(const std::string& text) {
  const PhotometricData data = parse_ies(text, "a.ies");
  EXPECT_EQ(data.info.symmetry, PhotometricSymmetry::rotational) << text;
  EXPECT_EQ(data.distribution(123, 0), 60) << text;
  EXPECT_EQ(data.distribution(321, 45), 40) << text;
  EXPECT_EQ(data.distribution(0, 90), 20) << text;
}

TEST(IesText, EveryLayout) {
  expect_rotational(kRotational);
  expect_rotational("\xEF\xBB\xBF\n" + kRotational);
  expect_rotational(kRotational + "\x1A garbage 1 2 3");
  expect_rotational(replaced(kRotational, "30 20 10\n", "30\n20\n\n10"));
  expect_rotational(replaced(kRotational, "30 20 10\n", "30, 20 ,10,\n"));
  expect_rotational(replaced(kRotational, "30 20 10\n", "+3.0e1\t.2E+2\t10.\n \n"));
  expect_rotational(replaced(kRotational, "TILT=NONE", " tilt = none  "));
  expect_rotational(replaced(kRotational, "TILT=NONE", "[OTHER\n[\n]\nfree text\nTILT=NONE"));
  expect_rotational(
      replaced(kRotational, "0.3\n1 1 50\n0 45 90\n0\n30", "0.3 1 1 50 0 45 90 0 30"));
  std::string with_cr = kRotational;
  std::replace(with_cr.begin(), with_cr.end(), '\n', '\r');
  expect_rotational(with_cr);
}

TEST(IesText, EveryVersion) {
  for (const char* version :
       {"IESNA91", "IESNA:LM-63-1991", "IESNA95", "IESNA:LM-63-1995 ", "iesna:lm-63-2002",
        "IESNA LM-63-2002", "IES:LM-63-2019", "\tIESNA:LM-63-95", "IESNA86", "LM-63-2002",
        "IESNA:LM-63-2002 rev 1", "IESLM-63-1995"}) {
    const auto data = parse_ies(type_c("0", "3 2 1", std::string(version) + "\n"), "a.ies");
    EXPECT_THAT(data.info.warnings, IsEmpty()) << version;
    EXPECT_THAT(version, HasSubstr(data.info.version));
    EXPECT_THAT(data.info.keywords, SizeIs(1));
  }
  const auto of_1986 = parse_ies(type_c("0", "3 2 1", "A luminaire\n\n"), "a.ies");
  EXPECT_EQ(of_1986.info.version, "");
  EXPECT_EQ(of_1986.info.keywords.at(0), std::pair(std::string(), std::string("A luminaire")));
  EXPECT_EQ(parse_ies(type_c("0", "3 2 1", "IES report 12\n"), "a.ies").info.version, "");
  const auto unknown = parse_ies(type_c("0", "3 2 1", "IESNA:LM-63-2040\n"), "a.ies");
  EXPECT_THAT(unknown.info.warnings, ElementsAre(HasSubstr("IESNA:LM-63-2040")));
}

TEST(IesText, TheNumberAfterTheBallastFactor) {
  const auto factor = [](const std::string& version) {
    const std::string text = replaced(type_c("0", "3 2 1", version), "\n1 1 50", "\n0.5 3 50");
    return parse_ies(text, "a.ies").info;
  };
  EXPECT_DOUBLE_EQ(factor("").intensity_factor, 2 * 0.5 * 3);
  EXPECT_DOUBLE_EQ(factor("IESNA91\n").intensity_factor, 2 * 0.5 * 3);
  EXPECT_DOUBLE_EQ(factor("IESNA:LM-63-1995\n").intensity_factor, 2 * 0.5);
  EXPECT_THAT(factor("IESNA:LM-63-2002\n").warnings, ElementsAre(HasSubstr("future use")));
  EXPECT_DOUBLE_EQ(factor("IES:LM-63-2019\n").intensity_factor, 2 * 0.5);
  EXPECT_THAT(factor("IES:LM-63-2019\n").warnings, IsEmpty());
}

TEST(IesText, AbsolutePhotometry) {
  const auto data = parse_ies(replaced(kRotational, "1 1000 2", "1 -1 2"), "a.ies");
  EXPECT_TRUE(data.info.absolute_photometry);
  EXPECT_FALSE(data.info.lamp_flux_lm.has_value());
  EXPECT_EQ(data.distribution(0, 0), 60);
}

/// Both texts stand for the same distribution.
void expect_twins(const std::string& text, const std::string& unfolded,
                  PhotometricSymmetry symmetry) {
  const auto a = parse_ies(text, "a.ies"), b = parse_ies(unfolded, "b.ies");
  EXPECT_EQ(a.info.symmetry, symmetry);
  EXPECT_EQ(a.distribution.horizontal_deg(), b.distribution.horizontal_deg()) << text;
  EXPECT_TRUE(
      std::ranges::equal(a.distribution.candela().values(), b.distribution.candela().values()))
      << text;
  EXPECT_THAT(a.info.warnings, IsEmpty());
}

TEST(IesText, SymmetriesOfTypeC) {
  using enum PhotometricSymmetry;
  expect_twins(type_c("0", "3 2 1"), type_c("0 360", "3 2 1\n3 2 1"), rotational);
  expect_twins(type_c("0 30 90", "1 2 3\n4 5 6\n7 8 9"),
               type_c("0 30 90 150 180 210 270 330 360",
                      "1 2 3\n4 5 6\n7 8 9\n4 5 6\n1 2 3\n4 5 6\n7 8 9\n4 5 6\n1 2 3"),
               quadrants);
  expect_twins(type_c("0 30 180", "1 2 3\n4 5 6\n7 8 9"),
               type_c("0 30 180 330 360", "1 2 3\n4 5 6\n7 8 9\n4 5 6\n1 2 3"), plane_0_180);
  expect_twins(
      type_c("90 180 200 270", "1 2 3\n4 5 6\n7 8 9\n3 2 1"),
      type_c("0 90 180 200 270 340 360", "4 5 6\n1 2 3\n4 5 6\n7 8 9\n3 2 1\n7 8 9\n4 5 6"),
      plane_90_270);
  expect_twins(type_c("-90 0 20 90", "1 2 3\n4 5 6\n7 8 9\n3 2 1"),
               type_c("0 20 90 160 180 270 360", "4 5 6\n7 8 9\n3 2 1\n7 8 9\n4 5 6\n1 2 3\n4 5 6"),
               plane_90_270);
  expect_twins(type_c("-180 0 90 180", "1 2 3\n4 5 6\n7 8 9\n1 2 3"),
               type_c("0 90 180 360", "4 5 6\n7 8 9\n1 2 3\n4 5 6"), none);
}

TEST(IesText, AnOpenCircleIsClosed) {
  const auto data = parse_ies(type_c("0 90 180 270", "1 2 3\n4 5 6\n7 8 9\n3 2 1"), "a.ies");
  EXPECT_THAT(data.info.warnings, ElementsAre(HasSubstr("0 to 270; the circle is closed")));
  EXPECT_THAT(data.distribution.horizontal_deg(), ElementsAre(0, 90, 180, 270, 360));
  EXPECT_EQ(data.distribution(315, 0), 4);  // Twice the mean of 3 and 1.
}

std::string type_ab(int type, const std::string& h, const std::string& v, const std::string& rows) {
  const auto count = [](const std::string& list) {
    return std::to_string(1 + std::count(list.begin(), list.end(), ' '));
  };
  return "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 " + count(v) + " " + count(h) + " " +
         std::to_string(type) + " 2 0 0 0\n1 1 50\n" + v + "\n" + h + "\n" + rows;
}

TEST(IesText, TypesAAndB) {
  for (const int type : {3, 2}) {
    const auto data = parse_ies(type_ab(type, "-10 0 40", "-5 5", "1 2\n3 4\n5 6"), "a.ies");
    EXPECT_EQ(data.distribution.type(), type == 3 ? PhotometricType::a : PhotometricType::b);
    EXPECT_EQ(data.info.symmetry, PhotometricSymmetry::none);
    EXPECT_EQ(data.distribution(-10, 5), 2);
    EXPECT_EQ(data.distribution(40, -5), 5);
    EXPECT_EQ(data.distribution(-11, 0), 0);
    expect_twins(type_ab(type, "0 10 40", "-5 5", "1 2\n3 4\n5 6"),
                 type_ab(type, "-40 -10 0 10 40", "-5 5", "5 6\n3 4\n1 2\n3 4\n5 6"),
                 PhotometricSymmetry::lateral);
  }
  EXPECT_THAT(parse_ies(type_ab(3, "-10 10", "0 5", "1 2\n3 4"), "a.ies").info.warnings,
              ElementsAre(HasSubstr("nothing is known below 0")));
}

TEST(IesText, TiltIncluded) {
  const auto data = parse_ies(
      replaced(kRotational, "TILT=NONE", "TILT=INCLUDE\n2\n3\n0 45 90\n1 .95 0.8"), "a.ies");
  ASSERT_TRUE(data.info.tilt.has_value());
  EXPECT_EQ(data.info.tilt->lamp_to_luminaire_geometry, 2);
  EXPECT_THAT(data.info.tilt->angles_deg, ElementsAre(0, 45, 90));
  EXPECT_THAT(data.info.tilt->multipliers, ElementsAre(1, 0.95, 0.8));
  EXPECT_EQ(data.distribution(0, 0), 60);
}

TEST(IesText, TiltFile) {
  const std::string text = replaced(kRotational, "TILT=NONE", "TILT=a lamp.tlt");
  EXPECT_THAT(parse_ies(text, "a.ies").info.warnings, ElementsAre(HasSubstr("a lamp.tlt")));
  std::string asked;
  const auto read = [&](const std::string& content) {
    return parse_ies(text, "a.ies", {[&, content](const std::string& name) {
                       asked = name;
                       return std::optional(content);
                     }});
  };
  EXPECT_THAT(read("1\n2\n0 90\n1 0.5\n").info.tilt->multipliers, ElementsAre(1, 0.5));
  EXPECT_EQ(asked, "a lamp.tlt");
  EXPECT_THROW(read("1\n2\n0 90\n1\n"), InputError);
  EXPECT_THROW(read("1\n2\n0 90\n1 1 1\n"), InputError);
  EXPECT_THROW(read("1\n2\n90 0\n1 1\n"), InputError);
}

/// "LINE: what is wrong".
std::string refusal(const std::string& text) {
  try {
    parse_ies(text, "a.ies");
  } catch (const InputError& error) {
    EXPECT_THAT(error.place(), StartsWith("a.ies:"));
    return error.place().substr(6) + ": " + error.message();
  }
  return "accepted";
}

TEST(IesText, ErrorsTellTheLine) {
  const std::string& good = kRotational;
  EXPECT_EQ(refusal(good), "accepted");
  EXPECT_THAT(refusal(""), AllOf(StartsWith("1: "), HasSubstr("TILT=")));
  EXPECT_THAT(refusal("IESNA91\n[TEST]\n"), AllOf(StartsWith("2: "), HasSubstr("TILT=")));
  EXPECT_THAT(refusal(replaced(good, " 10\n", "\n")),
              AllOf(StartsWith("8: the file ends before the intensity 3 of 3"),
                    HasSubstr("horizontal angle 0 (1 of 1)")));
  EXPECT_THAT(refusal(good + "\n5"), AllOf(StartsWith("10: "), HasSubstr("left over")));
  EXPECT_THAT(refusal(replaced(good, "30 20", "30 x20")),
              AllOf(StartsWith("8: \"x20\" is no number"), HasSubstr("intensity 2 of 3")));
  EXPECT_THAT(refusal(replaced(good, "30 20", "30 nan")), StartsWith("8: \"nan\""));
  EXPECT_THAT(refusal(replaced(good, "30 20", "30 -20")), HasSubstr("expected 0 to 3e38"));
  EXPECT_THAT(refusal(replaced(good, "30 20", "30,,20")), HasSubstr("between two commas"));
  EXPECT_THAT(refusal(replaced(good, "30 20", "30 1e60")), StartsWith("8: "));
  EXPECT_THAT(refusal(replaced(good, "0 45 90", "0 90 45")),
              StartsWith("6: the vertical angles don't ascend: 45 follows 90 (angle 3 of 3)"));
  EXPECT_THAT(refusal(replaced(good, "0 45 90", "0 45 45")), StartsWith("6: "));
  EXPECT_THAT(refusal(replaced(good, "0 45 90", "0 45 9000")), StartsWith("6: "));
  EXPECT_THAT(refusal(replaced(good, "2 3 1 1", "2 0 1 1")),
              StartsWith("4: the number of vertical angles is 0"));
  EXPECT_THAT(refusal(replaced(good, "2 3 1 1", "2 -3 1 1")), StartsWith("4: "));
  EXPECT_THAT(refusal(replaced(good, "2 3 1 1", "2 3.5 1 1")), HasSubstr("whole number"));
  EXPECT_THAT(refusal(replaced(good, "2 3 1 1", "2 3 1000000000 1")), StartsWith("4: "));
  EXPECT_THAT(refusal(replaced(good, "2 3 1 1", "2 3 0 1")), StartsWith("4: "));
  EXPECT_THAT(refusal(replaced(good, "2 3 1 1", "2 3 1 4")), HasSubstr("photometric type"));
  EXPECT_THAT(refusal(replaced(good, "1 1000 2", "1 1000 0")), HasSubstr("candela multiplier"));
  EXPECT_THAT(refusal(replaced(good, "1 1 50", "0 1 50")), HasSubstr("ballast factor"));
  EXPECT_THAT(refusal(replaced(good, "1 2 0.1", "1 3 0.1")), HasSubstr("units type"));
  EXPECT_THAT(refusal(type_c("0 10 100", "1 2 3\n1 2 3\n1 2 3")),
              AllOf(StartsWith("7: "), HasSubstr("go from 0 to 100, which fits no symmetry")));
  EXPECT_THAT(refusal(type_ab(3, "0 1", "0 95", "1 2\n3 4")), HasSubstr("-90 to 90"));
  EXPECT_THAT(refusal(type_ab(3, "0", "0 90", "1 2")), HasSubstr("one horizontal angle"));
}

/// Twenty thousand times twenty thousand intensities aren't allocated for a short file.
TEST(IesText, LongWordsAreToldWithoutBreakingTheirLetters) {
  std::string word(39, 'x');
  word += "\u00e9\u00e9";
  EXPECT_THAT(refusal(replaced(type_c("0", "30 20 10"), "30 20", "30 " + word)),
              AllOf(HasSubstr("\"" + word.substr(0, 39) + "...\""), Not(HasSubstr("\u00c3"))));
}

TEST(IesText, HugeCountsAreRefusedEarly) {
  std::string angles;
  for (int i = 0; i < 20'000; ++i) (angles += ' ') += std::to_string(i * 0.009);
  EXPECT_THAT(refusal("IESNA91\nTILT=NONE\n1 1 1 20000 20000 1 1 0 0 0 1 1 1\n" + angles + "\n" +
                      angles + "\n1 2 3"),
              HasSubstr("too short for 20000 x 20000"));
}

TEST(IesText, TextAfterTheLastIntensityIsAWarning) {
  EXPECT_THAT(parse_ies(kRotational + "\n\nEND OF 7 FILES", "a.ies").info.warnings,
              ElementsAre(HasSubstr("line 11: \"END\"")));
}

TEST(IesText, ShiftedRowsAreAWarning) {
  // A number is missing in the first row, and one is doubled in the second.
  const auto data = parse_ies(type_c("0 90", "30 20\n1 2 2 3"), "a.ies");
  EXPECT_THAT(data.info.warnings, ElementsAre(HasSubstr("line 9: the intensities of horizontal "
                                                        "angle 2 don't begin on a line")));
}

TEST(IesText, LooksLike) {
  EXPECT_TRUE(looks_like_ies(kRotational));
  EXPECT_FALSE(looks_like_ies("nothing\nATILT=NONE\nTILTED=1\n"));
}

}  // namespace
}  // namespace glare
