#include "glare/aperture/pupil_diameter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "glare/base/error.h"

namespace glare {
namespace {

/// Watson and Yellott's own closed form of the formula, for ages of 20 to 83 (their appendix 2, eq.
/// 27): `density` is luminance x area, times 0.1 for one eye.
double closed_form_mm(double density, double age) {
  const double f = std::pow(density, 0.41);
  return (18.5172 + 0.122165 * f - 0.105569 * age + 0.000138645 * f * age) / (2 + 0.0630635 * f);
}

TEST(PupilDiameter, AgreesWithThePublishedClosedForm) {
  for (const double luminance : {0.0, 1e-4, 0.01, 1.0, 100.0, 1e4})
    for (const double area : {1.0, 100.0, 900.0, 10000.0})
      for (const double age : {20.0, 28.58, 45.0, 83.0})
        for (const int eyes : {1, 2})
          // Its coefficients have 6 digits; 18.5172 is 0.00005 off what would be exact.
          EXPECT_NEAR(pupil_diameter_mm({luminance, area, age, eyes}),
                      closed_form_mm(luminance * area * (eyes == 1 ? 0.1 : 1), age), 2e-4)
              << luminance << " cd/m2, " << area << " deg2, " << age << ", " << eyes;
}

TEST(PupilDiameter, AtTheReferenceAgeIsStanleyAndDavies) {
  // (F / 846)^0.41 is 0, 1 and 2; and the limit of bright light is 2 mm.
  EXPECT_DOUBLE_EQ(pupil_diameter_mm({0, 100, 28.58, 2}), 7.75);
  EXPECT_NEAR(pupil_diameter_mm({8.46, 100, 28.58, 2}), 7.75 - 5.75 / 3, 1e-12);
  EXPECT_NEAR(pupil_diameter_mm({8.46 * std::pow(2, 1 / 0.41), 100, 28.58, 2}), 7.75 - 5.75 / 2,
              1e-12);
  EXPECT_NEAR(pupil_diameter_mm({1e6, 41253, 28.58, 2}), 2, 0.15);
}

TEST(PupilDiameter, OneEyeSeesATenth) {
  EXPECT_DOUBLE_EQ(pupil_diameter_mm({50, 300, 40, 1}), pupil_diameter_mm({5, 300, 40, 2}));
}

TEST(PupilDiameter, ShrinksWithLightAndWithAge) {
  EXPECT_GT(pupil_diameter_mm({1, 900, 30, 2}), pupil_diameter_mm({10, 900, 30, 2}));
  EXPECT_GT(pupil_diameter_mm({1, 900, 30, 2}), pupil_diameter_mm({1, 900, 60, 2}));
}

TEST(PupilDiameter, RefusesValuesOutsideTheirRange) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Adaptation& bad : {Adaptation{-1, 900, 30, 2},
                                {infinity, 900, 30, 2},
                                {1, 0, 30, 2},
                                {1, 5e4, 30, 2},
                                {1, 900, 19, 2},
                                {1, 900, 84, 2},
                                {1, 900, std::nan(""), 2},
                                {1, 900, 30, 0},
                                {1, 900, 30, 3}})
    EXPECT_THROW(pupil_diameter_mm(bad), OptionError);
}

}  // namespace
}  // namespace glare
