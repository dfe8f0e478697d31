#include "glare/spectrum/spectrum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "glare/base/error.h"

namespace glare {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Spectrum, IsLinearBetweenItsSamplesAndZeroOutside) {
  const Spectrum s({400, 500, 510}, {2, 4, -1});
  EXPECT_EQ(s(400), 2);
  EXPECT_EQ(s(500), 4);
  EXPECT_EQ(s(510), -1);
  EXPECT_DOUBLE_EQ(s(425), 2.5);
  EXPECT_NEAR(s(508), 0, 1e-15);  // Rounding.
  EXPECT_EQ(s(399.999999), 0);
  EXPECT_EQ(s(510.000001), 0);
  EXPECT_EQ(s(kNan), 0);
  EXPECT_EQ(s.range(), (WavelengthRange{400, 510}));
}

TEST(Spectrum, SortsItsSamples) {
  const Spectrum s({500, 510, 400}, {4, -1, 2});
  EXPECT_THAT(s.wavelengths_nm(), ElementsAre(400, 500, 510));
  EXPECT_THAT(s.values(), ElementsAre(2, 4, -1));
}

std::string refusal(const std::vector<double>& nm, const std::vector<double>& values) {
  try {
    const Spectrum s(nm, values);
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "spectrum");
    return error.what();
  }
  return "";
}

TEST(Spectrum, RefusesWhatIsNoTable) {
  EXPECT_THAT(refusal({}, {}), HasSubstr("fewer than two"));
  EXPECT_THAT(refusal({500}, {1}), HasSubstr("fewer than two"));
  EXPECT_THAT(refusal({500, 501}, {1}), HasSubstr("expected as many of both"));
  EXPECT_THAT(refusal({500, 501, 500}, {1, 2, 3}), HasSubstr("500 nm twice"));
  EXPECT_THAT(refusal({500, 0}, {1, 2}), HasSubstr("wavelength of 0 nm"));
  EXPECT_THAT(refusal({500, -380}, {1, 2}), HasSubstr("wavelength of -380 nm"));
  EXPECT_THAT(refusal({500, kInfinity}, {1, 2}), HasSubstr("wavelength of inf"));
  EXPECT_THAT(refusal({500, kNan}, {1, 2}), HasSubstr("wavelength of"));
  EXPECT_THAT(refusal({500, 501}, {1, kInfinity}), HasSubstr("at 501 nm"));
  EXPECT_THAT(refusal({500, 501}, {kNan, 1}), HasSubstr("at 500 nm"));
}

TEST(WavelengthRange, Intersection) {
  EXPECT_EQ(intersection({380, 780}, {360, 700}), (WavelengthRange{380, 700}));
  EXPECT_EQ(intersection({360, 700}, {380, 780}), (WavelengthRange{380, 700}));
  EXPECT_TRUE(intersection({380, 500}, {500, 780}).empty());  // One wavelength is no light.
  EXPECT_TRUE(intersection({380, 400}, {500, 780}).empty());
  EXPECT_FALSE((WavelengthRange{380, 381}).empty());
  EXPECT_TRUE((WavelengthRange{380, kNan}).empty());
}

TEST(UnionOfKnots, HoldsEverySampleWithinTheRangeOnceAndItsEnds) {
  const Spectrum a({400, 500, 600}, {1, 1, 1}), b({450, 500, 650}, {1, 1, 1});
  const std::array<const Spectrum*, 2> both = {&a, &b};
  EXPECT_THAT(union_of_knots(both, {420, 620}), ElementsAre(420, 450, 500, 600, 620));
  EXPECT_THAT(union_of_knots(both, {400, 650}), ElementsAre(400, 450, 500, 600, 650));
  EXPECT_THAT(union_of_knots({}, {1, 2}), ElementsAre(1, 2));
}

}  // namespace
}  // namespace glare
