#include "glare/color/color_space.h"

#include <gtest/gtest.h>

#include <limits>

#include "glare/base/error.h"

namespace glare {
namespace {

// A number printed with four decimals.
constexpr double kFourDecimals = 0.5e-4 + 1e-9;
// A few roundings in double precision, of numbers near 1.
constexpr double kRounding = 1e-14;

constexpr std::array<Chromaticity, 3> kNtscPrimaries = {{{0.67, 0.33}, {0.21, 0.71}, {0.14, 0.08}}};
constexpr Xyz kNtscWhite = {0.9804, 1, 1.1812};

void expect_near(const Matrix3& actual, const Matrix3& expected, double tolerance) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_NEAR(actual[row][column], expected[row][column], tolerance)
          << "row " << row << ", column " << column;
}

RgbColorSpace lin_rec2020() {
  return {"lin_rec2020",
          {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}}},
          xyz_from_chromaticity({0.3127, 0.3290})};
}

TEST(ColorSpace, Ntsc1953IsTheMatrixOfKakimoto2010) {
  const RgbColorSpace space("ntsc1953", kNtscPrimaries, kNtscWhite);
  expect_near(space.rgb_from_xyz(),
              {{{1.9106, -0.5326, -0.2883}, {-0.9843, 1.9984, -0.0283}, {0.0584, -0.1185, 0.8985}}},
              kFourDecimals);
}

TEST(ColorSpace, Rec709IsTheMatrixOfSrgb) {
  const RgbColorSpace space = lin_rec709_color_space();
  expect_near(space.xyz_from_rgb(),
              {{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}},
              kFourDecimals);
  // IEC 61966-2-1 inverted the rounded matrix above, which moves its entries by up to 4e-4.
  expect_near(space.rgb_from_xyz(),
              {{{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}},
              5e-4);
}

TEST(ColorSpace, AcesCgIsTheMatrixOfS2014004) {
  const RgbColorSpace space("acescg", {{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}}},
                            xyz_from_chromaticity({0.32168, 0.33767}));
  // Printed with ten decimals.
  expect_near(space.xyz_from_rgb(),
              {{{0.6624541811, 0.1340042065, 0.1561876870},
                {0.2722287168, 0.6740817658, 0.0536895174},
                {-0.0055746495, 0.0040607335, 1.0103391003}}},
              0.51e-10);
}

TEST(ColorSpace, Rec2020HasItsLuminanceWeightsAndTheConversionOfBt2087) {
  const Vector3 luminance = lin_rec2020().xyz_from_rgb()[1];
  EXPECT_NEAR(luminance[0], 0.2627, kFourDecimals);
  EXPECT_NEAR(luminance[1], 0.6780, kFourDecimals);
  EXPECT_NEAR(luminance[2], 0.0593, kFourDecimals);
  expect_near(lin_rec2020().rgb_from_xyz() * lin_rec709_color_space().xyz_from_rgb(),
              {{{0.6274, 0.3293, 0.0433}, {0.0691, 0.9195, 0.0114}, {0.0164, 0.0880, 0.8956}}},
              kFourDecimals);
}

TEST(ColorSpace, BradfordFromD65ToD50IsTheKnownMatrix) {
  // B. Lindbloom, "Chromatic adaptation", with the whites of ASTM E308; seven decimals.
  expect_near(bradford_adaptation({0.95047, 1, 1.08883}, {0.96422, 1, 0.82521}),
              {{{1.0478112, 0.0228866, -0.0501270},
                {0.0295424, 0.9904844, -0.0170491},
                {-0.0092345, 0.0150436, 0.7521316}}},
              0.51e-7);
}

TEST(ColorSpace, BradfordTakesOneWhiteToTheOther) {
  const Xyz from = {1.09850, 1, 0.35585};
  const Xyz to = {0.95047, 1, 1.08883};
  const Xyz adapted = bradford_adaptation(from, to) * from;
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(adapted[k], to[k], kRounding);
  expect_near(bradford_adaptation(to, from) * bradford_adaptation(from, to), identity_matrix(),
              kRounding);
}

TEST(ColorSpace, PrimariesAndWhiteComeBack) {
  const RgbColorSpace made("ntsc1953", kNtscPrimaries, kNtscWhite);
  const RgbColorSpace remade("again", made.rgb_from_xyz());
  EXPECT_EQ(remade.name(), "again");
  for (const RgbColorSpace& space : {made, remade})
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(space.primaries()[k].x, kNtscPrimaries[k].x, kRounding);
      EXPECT_NEAR(space.primaries()[k].y, kNtscPrimaries[k].y, kRounding);
      EXPECT_NEAR(space.white_xyz()[k], kNtscWhite[k], kRounding);
    }
  expect_near(made.rgb_from_xyz() * made.xyz_from_rgb(), identity_matrix(), kRounding);
}

TEST(ColorSpace, WhiteIsScaledToLuminanceOne) {
  const RgbColorSpace space("scaled", kNtscPrimaries, {98.04, 100, 118.12});
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(space.white_xyz()[k], kNtscWhite[k], kRounding);
}

TEST(ColorSpace, OnlyXyzIsXyz) {
  EXPECT_TRUE(xyz_color_space().is_xyz());
  EXPECT_EQ(xyz_color_space().name(), "xyz");
  EXPECT_FALSE(lin_rec709_color_space().is_xyz());
}

TEST(ColorSpace, ChromaticityAndColourAreInverse) {
  const Xyz xyz = xyz_from_chromaticity({0.3127, 0.3290});
  EXPECT_DOUBLE_EQ(xyz[1], 1);
  EXPECT_NEAR(chromaticity({5 * xyz[0], 5 * xyz[1], 5 * xyz[2]}).x, 0.3127, kRounding);
  EXPECT_NEAR(chromaticity({5 * xyz[0], 5 * xyz[1], 5 * xyz[2]}).y, 0.3290, kRounding);
}

TEST(ColorSpace, PrimariesOnOneLineAreAnError) {
  const Xyz white = {0.95, 1, 1.09};
  EXPECT_THROW(RgbColorSpace("", {{{0.1, 0.1}, {0.3, 0.3}, {0.6, 0.6}}}, white), InputError);
  EXPECT_THROW(RgbColorSpace("", {{{0.64, 0.33}, {0.64, 0.33}, {0.15, 0.06}}}, white), InputError);
  EXPECT_THROW(RgbColorSpace("", {{{0.64, 0}, {0.3, 0.6}, {0.15, 0.06}}}, white), InputError);
}

TEST(ColorSpace, ASingularOrInfiniteMatrixIsAnError) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(RgbColorSpace("", {{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}}}), InputError);
  EXPECT_THROW(RgbColorSpace("", {{{nan, 0, 0}, {0, 1, 0}, {0, 0, 1}}}), InputError);
}

TEST(ColorSpace, AWhiteWithoutPositiveConeResponsesIsAnError) {
  const Xyz white = {0.95047, 1, 1.08883};
  const Xyz saturated_blue = {0.1, 0.01, 1};  // its second cone response is negative
  EXPECT_THROW(bradford_adaptation(saturated_blue, white), InputError);
  EXPECT_THROW(bradford_adaptation(white, saturated_blue), InputError);
}

}  // namespace
}  // namespace glare
