#include "glare/scatter/straylight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "glare/base/error.h"

namespace glare {
namespace {

struct Check {
  double angle_deg, age_years, pigment, value;
  double last_digit;  ///< One unit of the last digit printed.
};

// Printed to five digits.
constexpr Check kChecks[] = {
    {0.1, 24, 0.5, 10511, 1},    {0.5, 24, 0.5, 100.54, 1e-2},  {1, 24, 0.5, 15.161, 1e-3},
    {3, 24, 0.5, 0.95628, 1e-5}, {10, 24, 0.5, 0.067446, 1e-6}, {30, 24, 0.5, 0.0089996, 1e-7},
    {1, 70, 1, 23.127, 1e-3},    {10, 70, 1, 0.16691, 1e-5},    {30, 70, 1, 0.025746, 1e-6}};

constexpr Straylight kEyes[] = {{0, 0},  {24, 0.5}, {35, 0.5}, {70, 1},
                                {70, 0}, {100, 0},  {100, 1.2}};

TEST(Straylight, TheGeneralEquationsCheckValues) {
  for (const Check& c : kChecks)
    EXPECT_NEAR(cie_general_glare(c.angle_deg, c.age_years, c.pigment), c.value, c.last_digit / 2)
        << c.angle_deg << " degrees, " << c.age_years << " years";
}

TEST(Straylight, FromATenthOfADegreeOnItIsTheEquation) {
  for (const Straylight& eye : kEyes)
    for (double angle = 0.1; angle <= 90; angle *= 1.01) {
      const double ratio = straylight_per_steradian(eye, angle) /
                           cie_general_glare(angle, eye.age_years, eye.pigment);
      EXPECT_LE(ratio, 1) << angle;
      EXPECT_GT(ratio, 1 - 0.008) << angle;
      if (angle > 0.13) {
        EXPECT_GT(ratio, 1 - 0.0004) << angle;
      }
    }
}

/// Change of ln S with ln angle.
double slope(const Straylight& eye, double angle) {
  constexpr double kStep = 1.001;
  return std::log(straylight_per_steradian(eye, angle * kStep) /
                  straylight_per_steradian(eye, angle / kStep)) /
         (2 * std::log(kStep));
}

TEST(Straylight, IsFiniteSmoothAndDecreasing) {
  for (const Straylight& eye : kEyes) {
    EXPECT_LT(straylight_per_steradian(eye, 0), 1e5);
    double before = straylight_per_steradian(eye, 0), slope_before = 0;
    for (double angle = 1e-3; angle <= 90; angle *= 1.01) {
      const double value = straylight_per_steradian(eye, angle), here = slope(eye, angle);
      EXPECT_LE(value, before) << angle;
      EXPECT_GT(value, 0);
      // The softened angle's own slope turns from 0 to 1 by at most 12 / 4 in an e-fold, S's by
      // three times that: 0.09 in this step.
      EXPECT_NEAR(here, slope_before, 0.1) << angle;
      before = value;
      slope_before = here;
    }
  }
}

/// By direction sine, with many equal steps: an obvious sum.
double plain_integral(const Straylight& eye, double from_deg) {
  constexpr int kSteps = 2000000;
  const double from = std::sin(from_deg * std::numbers::pi / 180);
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double sine = from + (1 - from) * (i + 0.5) / kSteps;
    sum += 2 * std::numbers::pi * sine *
           straylight_per_steradian(eye, std::asin(sine) * 180 / std::numbers::pi);
  }
  return sum * (1 - from) / kSteps;
}

TEST(Straylight, ItsEnergyIsTheIntegralOverDirections) {
  // Steps of 5e-7 against a plateau of 1.3e-3.
  for (const Straylight eye : {Straylight{24, 0.5}, Straylight{100, 1.2}})
    for (const double from : {0.0, 0.08, 2.0, 60.0})
      EXPECT_NEAR(scattered_energy(eye, from) / plain_integral(eye, from), 1, 1e-5) << from;
  EXPECT_EQ(scattered_energy({}, 90), 0);
}

TEST(Straylight, SomethingIsLeftForTheCoreAtEveryAgeAndPigment) {
  EXPECT_NEAR(scattered_energy({0, 0}), 0.44, 0.005);
  EXPECT_NEAR(scattered_energy({100, 1.2}), 0.98, 0.005);
  for (double age = 0; age < 100; age += 5)
    for (const double pigment : {0.0, 0.5, 1.0, 1.2})
      EXPECT_LT(scattered_energy({age, pigment}), scattered_energy({age + 5, pigment}));
}

TEST(Straylight, RefusesWhatIsOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double age : {-1.0, 100.5, 1e300, nan})
    EXPECT_THROW(require_valid({age, 0.5}), OptionError) << age;
  for (const double pigment : {-0.1, 1.3, nan})
    EXPECT_THROW(require_valid({35, pigment}), OptionError) << pigment;
  for (const double angle : {0.0, -1.0, nan})
    EXPECT_THROW(cie_general_glare(angle, 35, 0.5), OptionError) << angle;
  EXPECT_THROW(cie_general_glare(1, 120, 0.5), OptionError);
  EXPECT_THROW(straylight_per_steradian({}, -1), OptionError);
  EXPECT_THROW(straylight_per_steradian({35, nan}, 1), OptionError);
  EXPECT_THROW(scattered_energy({-3, 0.5}), OptionError);
  EXPECT_THROW(scattered_energy({}, nan), OptionError);
}

}  // namespace
}  // namespace glare
