// The reference itself, held against laws: whatever the library is compared with must be right.
#include "support/exact_template.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "support/apertures.h"
#include "support/color_difference.h"

namespace glare {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMmPerNm = 1e-6;

using exact::Observer;
using exact::Request;
using exact::SpectralTable;

std::vector<int> all_rows(int height) {
  std::vector<int> rows(height);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

double degrees(double radians) { return radians * 180 / kPi; }

// The mean of `psf_point` over the pixel centred on (x, y), by 5 x 5 Gauss-Legendre points.
double mean_of_points(const Aperture& aperture, double x, double y, double pitch, double nm) {
  constexpr double kNode[] = {-0.906179845938664, -0.538469310105683, 0, 0.538469310105683,
                              0.906179845938664};
  constexpr double kWeight[] = {0.236926885056189, 0.478628670499366, 0.568888888888889,
                                0.478628670499366, 0.236926885056189};
  double sum = 0;
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) {
      const double at_x = x + kNode[i] * pitch / 2, at_y = y + kNode[j] * pitch / 2;
      sum += kWeight[i] * kWeight[j] / 4 * exact::psf_point(aperture, at_x, at_y, nm);
    }
  }
  return sum;
}

// The largest difference of `psf` from the points' means, as a share of the largest value.
double error_of_means(const Aperture& aperture, const Request& request, double nm) {
  const Image<double> means = exact::psf(aperture, request, nm);
  const double pitch = request.pitch_rad();
  double error = 0, peak = 0;
  for (int r = 0; r < means.height(); ++r) {
    for (int i = 0; i < means.width(); ++i) {
      const double expected =
          mean_of_points(aperture, (i - request.width / 2) * pitch,
                         (request.rows[r] - request.height / 2) * pitch, pitch, nm);
      error = std::max(error, std::abs(means(i, r) - expected));
      peak = std::max(peak, expected);
    }
  }
  return error / peak;
}

TEST(ExactPsf, IsTheMeanOfThePointSumsOverEachPixel) {
  // A period of the pattern is cut into 36 pixels, of about half a fringe of the whole aperture;
  // five points a side then leave an error below 1e-9 of the value.
  const Aperture aperture = test::lopsided({18, 13, 0.36});
  const double period_rad = 550 * kMmPerNm / aperture.pixel_mm();
  for (const int width : {36, 37}) {
    const Request request{width, width - 6, degrees(period_rad), {3, 15, 16, 29}, 0, 0};
    EXPECT_LT(error_of_means(aperture, request, 550), 1e-9) << width;
  }
}

TEST(ExactPsf, KeepsTheTailOfALargeAperture) {
  // Rounding goes with the peak, and a pattern's tail is far below it.
  const test::Frame frame{96, 96, 8};
  const Aperture aperture = test::lashed_pupil(frame, 6);
  const double reach_deg = degrees(400 * kMmPerNm / frame.pixel_mm());
  const Request request{1201, 1201, reach_deg, {20}, 0, 0};
  const Image<double> tail = exact::psf(aperture, request, 400);
  const double pitch = request.pitch_rad();
  const double peak = exact::psf_point(aperture, 0, 0, 400);
  for (int i = 0; i < request.width; i += 97) {
    const double expected =
        mean_of_points(aperture, (i - 600) * pitch, (20 - 600) * pitch, pitch, 400);
    EXPECT_NEAR(tail(i, 0), expected, 1e-15 * peak);
    EXPECT_LT(expected, 1e-4 * peak);
  }
}

TEST(ExactPsf, OnTheAxisIsTheAreaOverTheSquareOfTheWavelength) {
  const Aperture aperture = test::square({40, 30, 4}, 2, {0.3, -0.2});  // edges between pixels
  const double expected = 4 / std::pow(550 * kMmPerNm, 2);
  EXPECT_NEAR(exact::psf_point(aperture, 0, 0, 550), expected, 1e-12 * expected);
  const Request tiny_pixels{3, 3, 1e-6, {1}, 0, 0};
  EXPECT_NEAR(exact::psf(aperture, tiny_pixels, 550)(1, 0), expected, 1e-9 * expected);
}

TEST(ExactPsf, OfASquareIsTheDirichletKernel) {
  // n samples a side: |sum| = sin(pi n p f) / sin(pi p f), without error.
  const Aperture aperture = test::square({40, 40, 4}, 2);
  const double lambda_mm = 600 * kMmPerNm, p = 0.1;
  const double fx = 1.23, fy = -0.41;
  const auto kernel = [&](double f) { return std::sin(kPi * 20 * p * f) / std::sin(kPi * p * f); };
  const double amplitude_mm2 = p * p * kernel(fx) * kernel(fy);
  const double expected = amplitude_mm2 * amplitude_mm2 / (lambda_mm * lambda_mm * 4);
  EXPECT_NEAR(exact::psf_point(aperture, fx * lambda_mm, fy * lambda_mm, 600), expected,
              1e-12 * expected);
}

TEST(ExactPsf, OfADiscIsTheAiryPattern) {
  // 200 samples across the disc; what anti-aliasing leaves of the edge's staircase, and the soft
  // edge itself, are seen at about 3e-5 of the amplitude on the axis.
  const double diameter_mm = 3, lambda_mm = 550 * kMmPerNm;
  const Aperture aperture = test::circle({256, 256, 3.84}, diameter_mm);
  const double on_axis = exact::psf_point(aperture, 0, 0, 550);
  EXPECT_NEAR(on_axis, kPi * 9 / 4 / (lambda_mm * lambda_mm), 0.01 * on_axis);
  for (double q = 0.25; q < 6; q += 0.25) {
    const double theta = q * lambda_mm / diameter_mm;
    const double amplitude = 2 * std::cyl_bessel_j(1, kPi * q) / (kPi * q);
    const double found = exact::psf_point(aperture, theta * 0.8, theta * 0.6, 550);
    EXPECT_NEAR(std::sqrt(found / on_axis), std::abs(amplitude), 5e-5) << q;
  }
  for (const double q : {1.219670, 2.233131, 3.238315}) {  // the dark rings
    const double theta = q * lambda_mm / diameter_mm;
    EXPECT_LT(exact::psf_point(aperture, theta, 0, 550), 1e-9 * on_axis) << q;
  }
}

TEST(ExactPsf, IntegratesToOneOverAPeriod) {
  const Aperture aperture = test::lopsided({24, 24, 0.6});
  const double period_rad = 480 * kMmPerNm / aperture.pixel_mm();
  for (const int size : {16, 33}) {
    const Request request{size, size, degrees(period_rad), all_rows(size), 0, 0};
    const Image<double> means = exact::psf(aperture, request, 480);
    const double sum = std::accumulate(means.values().begin(), means.values().end(), 0.0);
    EXPECT_NEAR(sum * request.pitch_rad() * request.pitch_rad(), 1, 1e-12);
  }
}

TEST(ExactPsf, SpotsOfAGratingStandAtMultiplesOfWavelengthOverPitch) {
  const Aperture aperture = test::grating({200, 100, 4}, 0.2);  // 5 samples open, 5 closed
  const double spot_rad = 500 * kMmPerNm / 0.2;
  const double on_axis = exact::psf_point(aperture, 0, 0, 500);
  const auto spot = [&](double x, double y) {
    return exact::psf_point(aperture, x * spot_rad, y * spot_rad, 500) / on_axis;
  };
  // The sum over the five samples of a bar; (2 / pi)^2 for finer and finer ones.
  EXPECT_NEAR(spot(1, 0), std::pow(5 * std::sin(kPi / 10), -2), 1e-9);
  EXPECT_LT(spot(2, 0), 1e-9);
  EXPECT_LT(spot(1.5, 0), 1e-2);
  EXPECT_LT(spot(0, 1), 1e-2);
}

// ---- Colour ----

// Three overlapping tents, broad enough to stand for colour matching functions.
Observer tents() {
  return {SpectralTable{{500, 600, 700}, {0, 1.1, 0}}, SpectralTable{{450, 555, 680}, {0, 1, 0}},
          SpectralTable{{400, 450, 520}, {0, 1.8, 0}}};
}

SpectralTable white_lamp() { return {{380, 780}, {1, 1}}; }
SpectralTable narrow_lamp() { return {{530.25, 537.5, 545.5}, {0, 2, 0}}; }

Request small_request(int refine) {
  const test::Frame frame{48, 48, 4};
  const double reach_deg = degrees(400 * kMmPerNm / frame.pixel_mm());
  return {32, 32, reach_deg, {2, 16, 21}, 400, 700, refine};
}

Aperture small_aperture() { return test::lashed_pupil({48, 48, 4}, 3.6); }

TEST(ExactXyz, TablesAreLinearAndZeroOutside) {
  const SpectralTable table{{400, 410, 430}, {1, 3, 2}};
  EXPECT_EQ(exact::value_at(table, 399.999), 0);
  EXPECT_EQ(exact::value_at(table, 400), 1);
  EXPECT_DOUBLE_EQ(exact::value_at(table, 404), 1.8);
  EXPECT_EQ(exact::value_at(table, 410), 3);
  EXPECT_DOUBLE_EQ(exact::value_at(table, 425), 2.25);
  EXPECT_EQ(exact::value_at(table, 430), 2);
  EXPECT_EQ(exact::value_at(table, 430.001), 0);
}

TEST(ExactXyz, IsTheIntegralOfThePatterns) {
  // The midpoint rule at 0.125 nm, every knot on its grid; its error is of second order in that.
  const Request request = small_request(1);
  const Aperture aperture = small_aperture();
  const SpectralTable lamp = narrow_lamp();
  Image<Xyz> sum(request.width, static_cast<int>(request.rows.size()));
  double luminance = 0;
  for (double nm = 530.25 + 0.0625; nm < 545.5; nm += 0.125) {
    const Image<double> pattern = exact::psf(aperture, request, nm);
    const double light = exact::value_at(lamp, nm);
    luminance += light * exact::value_at(tents()[1], nm);
    for (std::size_t i = 0; i < sum.values().size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        sum.values()[i][c] += light * exact::value_at(tents()[c], nm) * pattern.values()[i];
      }
    }
  }
  const std::vector<Image<Xyz>> found = exact::xyz(aperture, request, tents(), {lamp});
  ASSERT_EQ(found.size(), 1u);
  for (std::size_t i = 0; i < sum.values().size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double expected = sum.values()[i][c] / luminance;
      EXPECT_NEAR(found[0].values()[i][c], expected, 1e-4 * expected);
    }
  }
}

TEST(ExactXyz, IsConvergedInWavelength) {
  const std::vector<SpectralTable> lamps{white_lamp(), narrow_lamp()};
  const auto coarse = exact::xyz(small_aperture(), small_request(1), tents(), lamps);
  const auto fine = exact::xyz(small_aperture(), small_request(4), tents(), lamps);
  for (std::size_t l = 0; l < lamps.size(); ++l) {
    for (std::size_t i = 0; i < fine[l].values().size(); ++i) {
      for (int c = 0; c < 3; ++c) {
        const double expected = fine[l].values()[i][c];
        EXPECT_NEAR(coarse[l].values()[i][c], expected, 2e-5 * expected) << "lamp " << l;
      }
    }
  }
}

TEST(ExactXyz, OfAMixtureIsTheMixtureByLuminance) {
  SpectralTable mixture{{400, 530.25, 537.5, 545.5, 700}, {1, 1, 3, 1, 1}};
  const auto found = exact::xyz(small_aperture(), small_request(1), tents(),
                                {white_lamp(), narrow_lamp(), mixture});
  // Luminances: the area under y-bar, and the lamp's tent under the rise (nm - 450) / 105 of
  // y-bar: its area 15.25 times y-bar at its centre of mass, (530.25 + 537.5 + 545.5) / 3.
  const double white = 115, narrow = 15.25 * (1613.25 / 3 - 450) / 105;
  for (std::size_t i = 0; i < found[0].values().size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const double expected =
          (white * found[0].values()[i][c] + narrow * found[1].values()[i][c]) / (white + narrow);
      EXPECT_NEAR(found[2].values()[i][c], expected, 1e-12 * expected);
    }
  }
}

TEST(ExactXyz, DoesNotDependOnTheNumberOfThreads) {
  Request request = small_request(1);
  request.threads = 1;
  const auto one = exact::xyz(small_aperture(), request, tents(), {white_lamp()});
  request.threads = 3;
  const auto three = exact::xyz(small_aperture(), request, tents(), {white_lamp()});
  EXPECT_TRUE(
      std::equal(one[0].values().begin(), one[0].values().end(), three[0].values().begin()));
}

TEST(ExactXyz, LampColourIsTheRatioOfTheAreas) {
  const Xyz whole = exact::lamp_xyz(tents(), white_lamp(), 380, 780);
  EXPECT_NEAR(whole[0], 110.0 / 115, 1e-12);
  EXPECT_NEAR(whole[1], 1, 1e-15);
  EXPECT_NEAR(whole[2], 108.0 / 115, 1e-12);
  const Xyz up_to_555 = exact::lamp_xyz(tents(), white_lamp(), 380, 555);
  EXPECT_NEAR(up_to_555[0], 1.1 * 0.55 * 55 / 2 / 52.5, 1e-12);
}

TEST(ExactXyz, RefusesWhatHasNoAnswer) {
  const Aperture opaque{Image<float>(8, 8), 1};
  EXPECT_THROW(exact::psf(opaque, small_request(1), 550), std::invalid_argument);
  Request request = small_request(1);
  request.rows = {32};
  EXPECT_THROW(exact::psf(small_aperture(), request, 550), std::invalid_argument);
  EXPECT_THROW(exact::lamp_xyz(tents(), {{800, 900}, {1, 1}}, 380, 780), std::invalid_argument);
}

// ---- The difference of colours ----

struct Pair {
  test::Lab a, b;
  double difference;
};

// Sharma, Wu and Dalal 2005, table 1.
constexpr Pair kPublishedPairs[] = {
    {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
    {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
    {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
    {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
    {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
    {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
    {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
    {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
    {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
    {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
    {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
    {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
    {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
    {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
    {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
    {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
    {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
    {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
    {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
    {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
    {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
    {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
    {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
};

TEST(ColorDifference, AgreesWithThePublishedPairs) {
  for (const Pair& pair : kPublishedPairs) {  // printed to four places
    EXPECT_NEAR(test::ciede2000(pair.a, pair.b), pair.difference, 5.1e-5) << pair.a.a;
    EXPECT_NEAR(test::ciede2000(pair.b, pair.a), pair.difference, 5.1e-5) << pair.a.a;
  }
}

TEST(ColorDifference, LabOfWhiteAndOfDark) {
  const Xyz d65{0.95047, 1, 1.08883};
  const test::Lab white = test::lab_from_xyz(d65, d65);
  EXPECT_NEAR(white.L, 100, 1e-12);
  EXPECT_NEAR(std::hypot(white.a, white.b), 0, 1e-12);
  // On the linear part L* = (29 / 3)^3 Y / Y_n.
  EXPECT_NEAR(test::lab_from_xyz({0, 0.001, 0}, d65).L, 24389.0 / 27 * 0.001, 1e-12);
  EXPECT_NEAR(test::lab_from_xyz({0, 0, 0}, d65).L, 0, 1e-12);
}

TEST(ColorDifference, AtOwnLuminanceIsTheSameHoweverDim) {
  const Xyz d65{0.95047, 1, 1.08883};
  const Xyz reference{0.4, 0.5, 0.3}, color{0.42, 0.51, 0.29};
  const double bright = test::ciede2000_at_own_luminance(color, reference, d65);
  const Xyz dim_reference{4e-9, 5e-9, 3e-9}, dim_color{4.2e-9, 5.1e-9, 2.9e-9};
  EXPECT_NEAR(test::ciede2000_at_own_luminance(dim_color, dim_reference, d65), bright, 1e-9);
  EXPECT_NEAR(test::ciede2000_at_own_luminance(color, reference, d65),
              test::ciede2000(test::lab_from_xyz({0.84, 1.02, 0.58}, d65),
                              test::lab_from_xyz({0.8, 1.0, 0.6}, d65)),
              1e-12);
  EXPECT_THROW(test::ciede2000_at_own_luminance(color, {0, 0, 0}, d65), std::invalid_argument);
}

// ---- The test apertures ----

double open_area_mm2(const Aperture& aperture) {
  const auto values = aperture.transmittance.values();
  return std::accumulate(values.begin(), values.end(), 0.0) * std::pow(aperture.pixel_mm(), 2);
}

TEST(TestApertures, HaveTheAreasOfTheirShapes) {
  const test::Frame frame{120, 80, 6};
  // 16 x 16 points an edge pixel leave well under a thousandth of a pixel's area for each of the
  // few hundred edge pixels, at random; samples are rounded to float.
  EXPECT_NEAR(open_area_mm2(test::circle(frame, 3, {0.31, -0.17})), kPi * 9 / 4, 1e-3);
  EXPECT_NEAR(open_area_mm2(test::rectangle(frame, 1.234, 2.345, {0.1, 0.2})), 1.234 * 2.345, 1e-6);
  EXPECT_NEAR(open_area_mm2(test::slit(frame, 0.123)), 0.123 * 3.2, 1e-6);
  EXPECT_NEAR(open_area_mm2(test::grating(frame, 0.24)), 2.4 * 3.2, 1e-5);
  const double pupil = open_area_mm2(test::circle(frame, 3));
  const double lashed = open_area_mm2(test::lashed_pupil(frame, 3));
  EXPECT_GT(lashed, 0.95 * pupil);
  EXPECT_LT(lashed, 0.98 * pupil);
}

TEST(TestApertures, LashesStandInTheUpperHalf) {
  const test::Frame frame{80, 80, 4};
  const Aperture lashed = test::lashed_pupil(frame, 3), open = test::circle(frame, 3);
  for (int y = 40; y < 80; ++y) {
    EXPECT_TRUE(std::ranges::equal(lashed.transmittance.row(y), open.transmittance.row(y))) << y;
  }
}

// The largest correlation of the picture with a rearranged copy of itself, 1 if they are alike.
template <typename Rearranged>
double likeness(const Image<float>& t, const Rearranged& rearranged) {
  double both = 0, own = 0;
  for (int y = 0; y < t.height(); ++y) {
    for (int x = 0; x < t.width(); ++x) {
      both += t(x, y) * rearranged(x, y);
      own += t(x, y) * t(x, y);
    }
  }
  return both / own;
}

TEST(TestApertures, LopsidedLooksLikeNoneOfItsMirrorImages) {
  const Image<float> t = test::lopsided({60, 60, 3}).transmittance;
  const int last = 59;
  EXPECT_LT(likeness(t, [&](int x, int y) { return t(last - x, y); }), 0.8);
  EXPECT_LT(likeness(t, [&](int x, int y) { return t(x, last - y); }), 0.8);
  EXPECT_LT(likeness(t, [&](int x, int y) { return t(last - x, last - y); }), 0.8);
  EXPECT_LT(likeness(t, [&](int x, int y) { return t(y, x); }), 0.8);
  EXPECT_LT(likeness(t, [&](int x, int y) { return t(last - y, last - x); }), 0.8);
}

}  // namespace
}  // namespace glare
