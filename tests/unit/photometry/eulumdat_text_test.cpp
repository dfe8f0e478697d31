#include "glare/photometry/eulumdat_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "glare/base/error.h"

namespace glare {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// The lines of a file of 3 gammas; lists are of words.
struct Ldt {
  int symmetry = 0;
  std::string planes = "0 90 180 270";
  std::string rows;
  std::string plane_step = "90";
  std::string sets = "1 Lamp 2000 white 1A 55";
  int set_count = 1;
  std::string conversion = "1";

  std::vector<std::string> lines() const {
    const auto words = [](const std::string& text) {
      std::istringstream stream(text);
      std::vector<std::string> result;
      for (std::string word; stream >> word;) result.push_back(word);
      return result;
    };
    const auto angles = words(planes);
    std::vector<std::string> all = {"Company",
                                    "3",
                                    std::to_string(symmetry),
                                    std::to_string(angles.size()),
                                    plane_step,
                                    "3",
                                    "45",
                                    "report",
                                    "",
                                    "",
                                    "",
                                    "",
                                    "500",
                                    "200",
                                    "100",
                                    "400",
                                    "150",
                                    "10",
                                    "10",
                                    "10",
                                    "10",
                                    "100",
                                    "80.5",
                                    conversion,
                                    "0",
                                    std::to_string(set_count)};
    const auto append = [&](const std::vector<std::string>& more) {
      all.insert(all.end(), more.begin(), more.end());
    };
    append(words(sets));
    append(words("0 0,1 .2 0.3 0.4 0.5 0.6 0.7 0.8 0.9"));
    append(angles);
    append(words("0 45 90"));
    append(words(rows));
    return all;
  }
  std::string text(const std::string& end = "\n") const {
    std::string result;
    for (const std::string& line : lines()) result += line + end;
    return result;
  }
};

const Ldt kFull{.rows = "1 2 3 4 5 6 7 8 9 10 11 12"};

TEST(EulumdatText, ReadsWhatTheFileTells) {
  const auto data = parse_eulumdat(kFull.text("\r\n"), "a.ldt");
  EXPECT_EQ(data.info.format, "EULUMDAT");
  EXPECT_EQ(data.info.symmetry, PhotometricSymmetry::none);
  EXPECT_EQ(data.info.lamp_count, 1);
  EXPECT_EQ(data.info.lamp_flux_lm, 2000);
  EXPECT_DOUBLE_EQ(data.info.stated_flux_lm.value(), 1610);
  EXPECT_EQ(data.info.input_watts, 55);
  EXPECT_EQ(data.info.intensity_factor, 2);
  EXPECT_THAT(data.info.luminous_size_m, ElementsAre(0.4, 0.15, 0.01));
  EXPECT_THAT(data.info.keywords,
              ElementsAre(testing::Pair("MANUFAC", "Company"), testing::Pair("TEST", "report"),
                          testing::Pair("LAMP", "Lamp")));
  EXPECT_THAT(data.info.warnings, IsEmpty());
  EXPECT_THAT(data.distribution.horizontal_deg(), ElementsAre(0, 90, 180, 270, 360));
  EXPECT_EQ(data.distribution(90, 45), 10);
  EXPECT_EQ(data.distribution(360, 90), 6);
}

TEST(EulumdatText, EveryLayout) {
  const auto expect_same = [](const std::string& text) {
    const auto data = parse_eulumdat(text, "a.ldt"), same = parse_eulumdat(kFull.text(), "b.ldt");
    EXPECT_TRUE(std::ranges::equal(data.distribution.candela().values(),
                                   same.distribution.candela().values()));
  };
  const std::string text = kFull.text();
  expect_same(kFull.text("\r"));
  expect_same(kFull.text("  \r\n"));
  expect_same("\xEF\xBB\xBF" + text + "\n\n \n\x1A");
  expect_same(text.substr(0, text.size() - 1));
  std::string comma = text;
  comma.replace(comma.find("80.5"), 4, "80,5");
  expect_same(comma);
  const auto with_text = parse_eulumdat(text + "the end\n99\n", "a.ldt");
  EXPECT_THAT(with_text.info.warnings, ElementsAre(HasSubstr("the end")));
}

void expect_twins(const Ldt& part, const std::string& whole_rows, PhotometricSymmetry symmetry) {
  const auto a = parse_eulumdat(part.text(), "a.ldt");
  Ldt whole = part;
  whole.symmetry = 0;
  whole.rows = whole_rows;
  const auto b = parse_eulumdat(whole.text(), "b.ldt");
  EXPECT_EQ(a.info.symmetry, symmetry);
  EXPECT_EQ(a.distribution.horizontal_deg(), b.distribution.horizontal_deg());
  EXPECT_TRUE(
      std::ranges::equal(a.distribution.candela().values(), b.distribution.candela().values()));
  EXPECT_THAT(a.info.warnings, IsEmpty());
}

TEST(EulumdatText, Symmetries) {
  using enum PhotometricSymmetry;
  const std::string planes = "0 45 90 135 180 225 270 315";
  expect_twins({.symmetry = 2,
                .planes = planes,
                .rows = "1 1 1 2 2 2 3 3 3 4 4 4 5 5 5",
                .plane_step = "45"},
               "1 1 1 2 2 2 3 3 3 4 4 4 5 5 5 4 4 4 3 3 3 2 2 2", plane_0_180);
  // C270, C315, C0, C45, C90.
  expect_twins({.symmetry = 3,
                .planes = planes,
                .rows = "1 1 1 2 2 2 3 3 3 4 4 4 5 5 5",
                .plane_step = "45"},
               "3 3 3 4 4 4 5 5 5 4 4 4 3 3 3 2 2 2 1 1 1 2 2 2", plane_90_270);
  expect_twins({.symmetry = 4, .planes = planes, .rows = "1 1 1 2 2 2 3 3 3", .plane_step = "45"},
               "1 1 1 2 2 2 3 3 3 2 2 2 1 1 1 2 2 2 3 3 3 2 2 2", quadrants);
  for (const char* all : {"0", "0 120 240"}) {
    const auto data =
        parse_eulumdat(Ldt{.symmetry = 1, .planes = all, .rows = "7 8 9"}.text(), "a");
    EXPECT_EQ(data.info.symmetry, rotational);
    EXPECT_EQ(data.distribution(200, 45), 16);
    EXPECT_THAT(data.info.warnings, IsEmpty());
  }
}

TEST(EulumdatText, OnePlaneWithoutSymmetryIsForAll) {
  const auto data = parse_eulumdat(Ldt{.planes = "0", .rows = "7 8 9"}.text(), "a");
  EXPECT_EQ(data.info.symmetry, PhotometricSymmetry::rotational);
  EXPECT_THAT(data.info.warnings, ElementsAre(HasSubstr("one C-plane")));
  EXPECT_EQ(data.distribution(200, 45), 16);
}

TEST(EulumdatText, RoundedRightAnglesAreRightAngles) {
  const auto half = parse_eulumdat(
      Ldt{.symmetry = 2, .planes = "0 90.005 180.005 270", .rows = "1 1 1 2 2 2 3 3 3"}.text(),
      "a");
  EXPECT_THAT(half.distribution.horizontal_deg(), ElementsAre(0, 90, 180, 270, 360));
  const auto whole = parse_eulumdat(
      Ldt{.planes = "0 120 240 359.995", .rows = "1 1 1 2 2 2 3 3 3 1 1 1"}.text(), "a");
  EXPECT_EQ(whole.distribution.horizontal_deg().back(), 360);
}

TEST(EulumdatText, SetsOfLamps) {
  Ldt two = kFull;
  two.set_count = 2;
  two.sets = "1 A 2000 x y 55 2 B 3000 x y 60";
  const auto first = parse_eulumdat(two.text(), "a.ldt");
  EXPECT_EQ(first.distribution(90, 45), 10);
  EXPECT_THAT(first.info.warnings, ElementsAre(HasSubstr("2 sets of lamps")));
  const auto second = parse_eulumdat(two.text(), "a.ldt", {.lamp_set = 2});
  EXPECT_EQ(second.distribution(90, 45), 15);
  EXPECT_EQ(second.info.lamp_count, 2);
  EXPECT_EQ(second.info.input_watts, 60);
  EXPECT_THAT(second.info.warnings, IsEmpty());
  EXPECT_THROW(parse_eulumdat(two.text(), "a.ldt", {.lamp_set = 3}), OptionError);
}

TEST(EulumdatText, AbsolutePhotometryAndConversion) {
  Ldt absolute = kFull;
  absolute.sets = "-1 LED 2000 x y 20";
  absolute.conversion = "1,5";
  const auto data = parse_eulumdat(absolute.text(), "a.ldt");
  EXPECT_TRUE(data.info.absolute_photometry);
  EXPECT_FALSE(data.info.lamp_flux_lm.has_value());
  EXPECT_EQ(data.info.lamp_count, 1);
  EXPECT_EQ(data.distribution(90, 45), 15);
  absolute.conversion = "0";
  EXPECT_THAT(parse_eulumdat(absolute.text(), "a.ldt").info.warnings,
              ElementsAre(HasSubstr("taken as 1")));
}

TEST(EulumdatText, AnglesThatDisagreeWithTheStep) {
  Ldt odd = kFull;
  odd.planes = "0 90 180 280";
  const auto data = parse_eulumdat(odd.text(), "a.ldt");
  EXPECT_THAT(data.info.warnings, ElementsAre(HasSubstr("there is 280 instead of 270")));
  EXPECT_THAT(data.distribution.horizontal_deg(), ElementsAre(0, 90, 180, 280, 360));
}

std::string refusal(const std::string& text) {
  try {
    parse_eulumdat(text, "a.ldt");
  } catch (const InputError& error) {
    EXPECT_THAT(error.place(), StartsWith("a.ldt:"));
    return error.place().substr(6) + ": " + error.message();
  }
  return "accepted";
}

/// The text with another line `number`, from 1.
std::string with_line(int number, const std::string& line) {
  auto lines = kFull.lines();
  lines[static_cast<std::size_t>(number - 1)] = line;
  std::string text;
  for (const std::string& each : lines) text += each + "\n";
  return text;
}

TEST(EulumdatText, ErrorsTellTheLine) {
  EXPECT_EQ(refusal(kFull.text()), "accepted");
  EXPECT_THAT(refusal(""), StartsWith("0: the file ends before the company's name"));
  EXPECT_THAT(refusal(with_line(2, "x")), StartsWith("2: \"x\" is no number"));
  EXPECT_THAT(refusal(with_line(3, "5")), StartsWith("3: the symmetry indicator is 5"));
  EXPECT_THAT(refusal(with_line(4, "0")), StartsWith("4: "));
  EXPECT_THAT(refusal(with_line(4, "2147483648")), StartsWith("4: "));
  EXPECT_THAT(refusal(with_line(6, "-3")), StartsWith("6: "));
  EXPECT_THAT(refusal(with_line(6, "2.5")), HasSubstr("whole number"));
  EXPECT_THAT(refusal(with_line(26, "0")), StartsWith("26: the number of sets"));
  EXPECT_THAT(refusal(with_line(29, "0")), StartsWith("29: the total flux"));
  EXPECT_THAT(refusal(with_line(29, "")), StartsWith("29: the line is empty"));
  EXPECT_THAT(refusal(with_line(33, "direct")), StartsWith("33: "));
  EXPECT_THAT(refusal(with_line(45, "80")), AllOf(StartsWith("45: "), HasSubstr("80 after 90")));
  EXPECT_THAT(refusal(with_line(49, "200")), StartsWith("49: "));
  EXPECT_THAT(refusal(with_line(55, "-1")), StartsWith("55: an intensity is -1"));
  EXPECT_THAT(refusal(with_line(55, "")), StartsWith("55: the line is empty"));
  // One more or fewer plane or gamma than there are.
  EXPECT_THAT(refusal(with_line(4, "3")), StartsWith("46: "));
  EXPECT_THAT(refusal(with_line(4, "5")), StartsWith("47: "));
  EXPECT_THAT(refusal(with_line(6, "2")), AllOf(StartsWith("57: "), HasSubstr("left over")));
  EXPECT_THAT(refusal(with_line(6, "4")), StartsWith("50: "));
  EXPECT_THAT(refusal(kFull.text() + "1\n"), AllOf(StartsWith("62: "), HasSubstr("left over")));
  const std::string text = kFull.text();
  EXPECT_THAT(refusal(text.substr(0, text.size() - 3)), StartsWith("60: the file ends before"));
}

TEST(EulumdatText, PlanesThatDontFitTheSymmetry) {
  Ldt odd{.symmetry = 2, .planes = "0 90 170 270", .rows = "1 2 3 4 5 6 7 8 9"};
  EXPECT_THAT(refusal(odd.text()), AllOf(StartsWith("46: "), HasSubstr("no plane C 180")));
  odd.planes = "0 45 90 180";
  EXPECT_THAT(refusal(odd.text()), HasSubstr("4 C-planes in the part"));
  odd.symmetry = 3;
  EXPECT_THAT(refusal(odd.text()), HasSubstr("no plane C 270"));
}

TEST(EulumdatText, LooksLike) {
  EXPECT_TRUE(looks_like_eulumdat(kFull.text("\r\n")));
  EXPECT_TRUE(looks_like_eulumdat(with_line(5, ""))) << "unequal steps may be told so";
  EXPECT_FALSE(looks_like_eulumdat("IESNA91\nTILT=NONE\n"));
  EXPECT_FALSE(looks_like_eulumdat(with_line(3, "7")));
}

}  // namespace
}  // namespace glare
