#include "glare/wavefront/aberrations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "glare/base/error.h"
#include "support/apertures.h"

namespace glare {
namespace {

/// Thibos et al. 1992: about 2.1 D from 400 to 700 nm, and none at 589.
TEST(Aberrations, ChromaticEyeIsAsPublished) {
  EXPECT_NEAR(chromatic_refraction_dioptre(589), 0, 0.005);
  EXPECT_NEAR(chromatic_refraction_dioptre(400), -1.722, 0.001);
  EXPECT_NEAR(chromatic_refraction_dioptre(700), 0.3815, 0.001);
  Aberrations a;
  EXPECT_EQ(chromatic_difference_dioptre(a, 400), 0);
  a.chromatic = true;
  a.focused_nm = 550;
  EXPECT_EQ(chromatic_difference_dioptre(a, 550), 0);
}

/// OSA/ANSI: M = -4 sqrt(3) c_2^0 / r^2, so the two differ by a constant.
TEST(Aberrations, DefocusIsTheZernikeTermOfTheSameRefraction) {
  Aberrations sphere, zernike;
  sphere.defocus_dioptre = -1.5;
  zernike.zernike = {6, {{4, 1.5 * 9 / (4 * std::sqrt(3))}}};
  const auto difference = [&](double x, double y) {
    return optical_path_um(sphere, {x, y}, 500) - optical_path_um(zernike, {x, y}, 500);
  };
  EXPECT_NEAR(difference(1, 2), difference(0, 0), 1e-12);
  EXPECT_NEAR(optical_path_um(sphere, {0, 2}, 500), 3, 1e-12);
}

TEST(Aberrations, StilesCrawfordIsHalfTheExponentInAmplitude) {
  const Aperture open = test::square({64, 64, 6.4}, 6.4);
  const Aperture seen = apodized(open, {0.05, {1, 0.5}}, {});
  // The sample at (2.05, 1.45) mm right and up: column 52, row 17.
  const double square_mm2 = 1.05 * 1.05 + 0.95 * 0.95;
  EXPECT_NEAR(std::pow(seen.transmittance(52, 17), 2), std::pow(10, -0.05 * square_mm2), 1e-6);
}

TEST(Aberrations, PistonAloneIsNoPhase) {
  Aberrations a;
  EXPECT_TRUE(a.empty());
  a.zernike = {6, {{0, 3}, {4, 0}}};
  EXPECT_FALSE(a.has_phase());
  a.zernike.coefficients[1].value_um = 0.1;
  EXPECT_TRUE(a.has_phase());
}

TEST(Aberrations, NumbersOutsideTheirRangesAreRefused) {
  const auto refused = [](auto change) {
    Aberrations a;
    a.zernike = {6, {{4, 0.1}}};
    a.stiles_crawford = StilesCrawford{};
    require_valid(a);
    change(a);
    EXPECT_THROW(require_valid(a), OptionError);
  };
  refused([](Aberrations& a) { a.defocus_dioptre = 51; });
  refused([](Aberrations& a) { a.defocus_dioptre = std::numeric_limits<double>::quiet_NaN(); });
  refused([](Aberrations& a) { a.zernike.pupil_diameter_mm = 0; });
  refused([](Aberrations& a) { a.zernike.coefficients.push_back({4, 0.2}); });
  refused([](Aberrations& a) { a.zernike.coefficients[0].j = -1; });
  refused([](Aberrations& a) { a.zernike.coefficients[0].j = 231; });
  refused([](Aberrations& a) { a.zernike.coefficients[0].value_um = 1e4; });
  refused([](Aberrations& a) { a.focused_nm = 200; });
  refused([](Aberrations& a) { a.stiles_crawford->rho_per_mm2 = -0.1; });
}

}  // namespace
}  // namespace glare
