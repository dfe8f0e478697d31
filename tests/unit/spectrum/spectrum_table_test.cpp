#include "glare/spectrum/spectrum_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "glare/base/error.h"

namespace glare {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// What each of these texts stands for: 380 nm, 0.5 and 390.5 nm, 25.
void expect_lamp(const std::string& text) {
  const Spectrum s = parse_lamp_table(text, "lamp.csv");
  EXPECT_THAT(s.wavelengths_nm(), ElementsAre(380, 390.5)) << text;
  EXPECT_THAT(s.values(), ElementsAre(0.5, 25)) << text;
}

TEST(SpectrumTable, EveryDialect) {
  expect_lamp("380,0.5\n390.5,25\n");
  expect_lamp("380, 0.5\n390.5, 25");
  expect_lamp("380;0,5\n390,5;25\n");
  expect_lamp("380;0.5\n390.5;25\n");
  expect_lamp("380\t0,5\n390,5\t25\n");
  expect_lamp("380\t0.5\n390.5\t2.5e1\n");
  expect_lamp("380 0.5\n390.5    25\n");
  expect_lamp("  380   .5  \n\t390.5 +25\n");
  expect_lamp("\"380\",\"0.5\"\n\"390.5\",\" 25 \"\n");
  expect_lamp("390.5,25\n380,0.5\n");
}

TEST(SpectrumTable, EveryLineEnding) {
  expect_lamp("380,0.5\r\n390.5,25\r\n");
  expect_lamp("380,0.5\r390.5,25\r");
  expect_lamp("\n\n380,0.5\n\n\n390.5,25");
}

TEST(SpectrumTable, PassesOverWhatIsNoNumber) {
  expect_lamp(
      "\xEF\xBB\xBF"
      "380,0.5\n390.5,25\n");
  expect_lamp(
      "\xEF\xBB\xBF"
      "wavelength_nm,power\n380,0.5\n390.5,25\n");
  expect_lamp("# measured on Monday, 12.5 m away\n380,0.5 # here\n390.5,25\n#");
  expect_lamp("My lamp\nWavelength (nm);Relative power\n380;0,5\n390,5;25\n");
  expect_lamp("380,0.5,7,seven\n390.5,25,,\n");
}

TEST(SpectrumTable, RowsKnowTheirLines) {
  const NumberTable table = parse_number_table("a,b,c\n\n1,2,3\n# no\n4,5,6,7\n", "t", 3);
  EXPECT_THAT(table.line_numbers, ElementsAre(3, 5));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre(1, 2, 3), ElementsAre(4, 5, 6)));
  EXPECT_TRUE(parse_number_table("", "t", 3).rows.empty());
}

struct Refusal {
  std::string place, message;
};

Refusal refusal(const std::string& text) {
  try {
    parse_lamp_table(text, "lamp.csv");
  } catch (const InputError& error) {
    return {error.place(), error.what()};
  }
  return {"", "(was accepted)"};
}

TEST(SpectrumTable, SaysWhichLineIsNoRowOfNumbers) {
  struct Case {
    const char* text;
    const char* place;
  };
  for (const Case& c : {Case{"380,1\n390\n400,1\n", "lamp.csv:2"},
                        {"380,1\n\n390,x\n", "lamp.csv:3"},
                        {"380,1\r\n390,1\r\nend of file\r\n", "lamp.csv:3"},
                        {"nm,1\n380,1\n", "lamp.csv:1"},
                        {"380,1\r390,\r", "lamp.csv:2"},
                        {"380,1\n390,1e\n", "lamp.csv:2"},
                        {"380,1\n390,1.5.2\n", "lamp.csv:2"},
                        {"380,1\n390,--1\n", "lamp.csv:2"},
                        {"380;1\n390;1.000,5\n", "lamp.csv:2"},
                        {"380 1\n390 1mW\n", "lamp.csv:2"}}) {
    const Refusal found = refusal(c.text);
    EXPECT_EQ(found.place, c.place) << c.text;
    EXPECT_THAT(found.message, AllOf(StartsWith(c.place), HasSubstr("isn't a row of 2 numbers")));
  }
  EXPECT_THAT(refusal("380,1\nend of file\n").message, HasSubstr("\"end of file\""));
}

TEST(SpectrumTable, NumbersBeyondDoublePrecisionAreZeroOrInfinite) {
  EXPECT_THAT(refusal("380,1\n390,1e999\n").message, HasSubstr("not finite"));
  EXPECT_EQ(parse_lamp_table("380,1\n390,1e-999\n", "lamp.csv").values()[1], 0);
}

TEST(SpectrumTable, SaysWhichLineHoldsAnImpossibleLamp) {
  EXPECT_EQ(refusal("nm,p\n380,1\n-390,1\n").message,
            "lamp.csv:3: the wavelength isn't a positive number of nanometres");
  EXPECT_EQ(refusal("0,1\n390,1\n").place, "lamp.csv:1");
  EXPECT_EQ(refusal("380,1\ninf,1\n").place, "lamp.csv:2");
  EXPECT_EQ(refusal("380,1\n390,-0.1\n").message,
            "lamp.csv:2: the power is negative or not finite");
  EXPECT_EQ(refusal("380,1\n390,nan\n").place, "lamp.csv:2");
  EXPECT_EQ(refusal("380,1\n390,2\n# twice\n380,1\n").message,
            "lamp.csv:4: the wavelength stands in line 1 already");
}

TEST(SpectrumTable, RefusesATableThatIsTooShortOrDark) {
  EXPECT_EQ(refusal("").place, "lamp.csv");
  EXPECT_THAT(refusal("").message, HasSubstr("0 rows"));
  EXPECT_THAT(refusal("wavelength_nm,power\n").message, HasSubstr("0 rows"));
  EXPECT_THAT(refusal("380,1\n").message, HasSubstr("1 row"));
  EXPECT_THAT(refusal("380,0\n390,0\n").message, HasSubstr("0 at every wavelength"));
}

}  // namespace
}  // namespace glare
