#include "glare/diffraction/far_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "glare/base/error.h"
#include "support/templates.h"

namespace glare {
namespace {

/// I(f) by its definition, the samples being p^2 of area each.
double direct_mm2(const Aperture& aperture, double fx_per_mm, double fy_per_mm) {
  const double p = aperture.pixel_mm();
  std::complex<double> sum = 0;
  for (int y = 0; y < aperture.transmittance.height(); ++y)
    for (int x = 0; x < aperture.transmittance.width(); ++x)
      sum += std::polar<double>(aperture.transmittance(x, y),
                                -2 * std::numbers::pi * p * (x * fx_per_mm + y * fy_per_mm));
  return std::norm(p * p * sum) / energy_area_mm2(aperture);
}

/// Every sample that is held.
void expect_direct(const Aperture& aperture, const FarFieldRequest& request) {
  const FarField f = far_field(aperture, request);
  const double peak = direct_mm2(aperture, 0, 0);
  for (int r = 0; r < f.intensity_mm2.height(); ++r)
    for (int c = 0; c < f.intensity_mm2.width(); ++c)
      ASSERT_NEAR(f.intensity_mm2(c, r),
                  direct_mm2(aperture, (r + f.first_kx) * f.bin_x_per_mm,
                             (c + f.first_ky) * f.bin_y_per_mm),
                  1e-6 * peak)  // Single precision.
          << "kx " << r + f.first_kx << ", ky " << c + f.first_ky;
}

FarFieldRequest request_to(double x_per_mm, double y_per_mm, double overlap_per_mm = 0) {
  FarFieldRequest request;
  request.max_frequency_x_per_mm = x_per_mm;
  request.max_frequency_y_per_mm = y_per_mm;
  request.overlap_frequency_x_per_mm = overlap_per_mm;
  request.threads = 2;
  return request;
}

/// Samples without any symmetry.
Aperture uneven(int width, int height, double width_mm) {
  return {
      test::picture(width, height, [](int x, int y) { return ((7 * x + 5 * y * y) % 11) / 10.; }),
      width_mm};
}

TEST(FarField, IsTheFourierTransformOfTheAperture) {
  for (const double padding : {2.0, 4.0, 6.0}) {
    auto request = request_to(3, 5);
    request.padding = padding;
    expect_direct(uneven(9, 9, 0.9), request);
    expect_direct(uneven(20, 7, 2), request);
    expect_direct(uneven(5, 23, 0.5), request);
  }
}

TEST(FarField, RepeatsBeyondTheReachOfItsSamples) {
  const Aperture aperture = uneven(9, 6, 0.9);  // Repeats after 10 cycles per mm.
  expect_direct(aperture, request_to(12, 14, 7));
  expect_direct(aperture, request_to(26, 3));
}

TEST(FarField, HoldsAsMuchBeyondTheAxisAsIsAskedFor) {
  const Aperture aperture = uneven(9, 6, 0.9);
  expect_direct(aperture, request_to(4, 4, 4));
  const FarField f = far_field(aperture, request_to(4, 3, 1.5));
  EXPECT_LE((f.first_kx + kFarFieldMargin) * f.bin_x_per_mm, -1.5);
  const int last_kx = f.first_kx + f.intensity_mm2.height() - 1;
  EXPECT_GE((last_kx - kFarFieldMargin) * f.bin_x_per_mm, 4);
  EXPECT_EQ(f.intensity_mm2.width(), -2 * f.first_ky + 1);
  EXPECT_LE((f.first_ky + kFarFieldMargin) * f.bin_y_per_mm, -3);
}

TEST(FarField, OfOneSampleIsFlat) {
  Aperture aperture{Image<float>(4, 3), 0.4};
  aperture.transmittance(3, 1) = 0.25f;
  const FarField f = far_field(aperture, request_to(20, 20, 20));
  for (const float i : f.intensity_mm2.values()) ASSERT_NEAR(i, 0.01, 1e-8);  // p^2
  EXPECT_DOUBLE_EQ(f.extent_x_mm, 0.1);
  EXPECT_DOUBLE_EQ(f.extent_y_mm, 0.1);
}

TEST(FarField, KnowsItsAperture) {
  Aperture aperture = uneven(40, 30, 8);
  for (int x = 0; x < 40; ++x) aperture.transmittance(x, 0) = aperture.transmittance(x, 29) = 0;
  const FarField f = far_field(aperture, request_to(1, 1));
  EXPECT_DOUBLE_EQ(f.aperture_pixel_mm, 0.2);
  EXPECT_DOUBLE_EQ(f.aperture_width_mm, 8);
  EXPECT_DOUBLE_EQ(f.energy_area_mm2, energy_area_mm2(aperture));
  EXPECT_DOUBLE_EQ(f.extent_x_mm, 8);
  EXPECT_DOUBLE_EQ(f.extent_y_mm, 28 * 0.2);
}

TEST(FarField, StandsAnywhereInThePicture) {
  const auto at = [](int x0, int y0) {
    Aperture aperture{Image<float>(30, 30), 3};
    const Aperture part = uneven(9, 9, 0.9);
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 9; ++x) aperture.transmittance(x0 + x, y0 + y) = part.transmittance(x, y);
    return far_field(aperture, request_to(3, 3));
  };
  EXPECT_TRUE(
      std::ranges::equal(at(0, 0).intensity_mm2.values(), at(21, 13).intensity_mm2.values()));
}

TEST(FarField, RefusesAnApertureThatIsNone) {
  EXPECT_THROW(far_field({Image<float>(8, 8), 1}, request_to(1, 1)), InputError);
  EXPECT_THROW(far_field({Image<float>(8, 8, 2.0f), 1}, request_to(1, 1)), InputError);
  EXPECT_THROW(far_field({Image<float>(8, 8, 1.0f), 0}, request_to(1, 1)), InputError);
}

TEST(FarField, CanBeCancelled) {
  auto request = request_to(5, 5);
  request.progress = [](double) { return false; };
  EXPECT_THROW(far_field(uneven(9, 9, 0.9), request), Cancelled);
}

TEST(FarField, HasTheSameBitsHoweverMuchIsAskedForOnAnyNumberOfThreads) {
  const Aperture aperture = uneven(301, 280, 30.1);
  auto request = request_to(5, 5, 1);  // All within reach: the passes share the field's memory.
  const FarField whole = far_field(aperture, request);
  for (const double most_per_mm : {0.4, 2.0, 2.7, 4.5, 5.0})
    for (const int threads : {1, 3}) {
      request = request_to(most_per_mm, most_per_mm);
      request.threads = threads;
      const FarField part = far_field(aperture, request);
      const auto width = static_cast<std::size_t>(part.intensity_mm2.width());
      for (int r = 0; r < part.intensity_mm2.height(); ++r) {
        const auto row = whole.intensity_mm2.row(r + part.first_kx - whole.first_kx);
        ASSERT_TRUE(std::ranges::equal(part.intensity_mm2.row(r),
                                       row.subspan(part.first_ky - whole.first_ky, width)))
            << most_per_mm << ", row " << r;
      }
    }
}

TEST(FarField, TakesLittleMoreThanItsOwnMemoryWhereAllIsWithinReach) {
  auto request = request_to(5, 5);
  request.threads = 1;
  const FarField f = far_field(uneven(400, 400, 40), request);
  EXPECT_LT(far_field_bytes(400, 400, 0.1, request),
            1.3 * static_cast<double>(f.intensity_mm2.values().size_bytes()));
}

TEST(FarField, TellsHowManyBytesItTakes) {
  const auto request = request_to(4, 9, 1);
  const FarField f = far_field(uneven(90, 60, 9), request);
  EXPECT_GT(far_field_bytes(90, 60, 0.1, request), f.intensity_mm2.values().size_bytes());
  EXPECT_LT(far_field_bytes(90, 60, 0.1, request), far_field_bytes(180, 60, 0.1, request));
}

}  // namespace
}  // namespace glare
