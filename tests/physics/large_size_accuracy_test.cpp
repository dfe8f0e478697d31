// Large templates against the exact reference, at pixels spread over radius and angle.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "glare/glare.h"
#include "support/bins_pitch_case.h"
#include "support/exact_pixels.h"
#include "support/lamps.h"
#include "support/pixel_errors.h"

namespace glare {
namespace {

constexpr double kMedianLimit = 0.0005, kPercentile99Limit = 0.003, kDeltaE99Limit = 0.2;

constexpr int kPixels = 2000;

const char* const kLamps[] = {"HP5", "FL11", "lines"};

Spectrum lamp_of(const std::string& name) {
  return name == "lines" ? test::lamp_with_narrow_lines() : *find_lamp(name);
}

/// Limits are `times` as wide for patterns that are harder than an eye's.
void expect_small(const test::PixelErrors& errors, const std::string& label, double times = 1) {
  const double median = test::percentile(errors.luminance, 0.5);
  const double p99 = test::percentile(errors.luminance, 0.99);
  const double delta_e_99 = test::percentile(errors.delta_e, 0.99);
  std::printf("%-18s %zu px  luminance: median %.4f %%, 99th %.4f %%;  CIEDE2000: 99th %.4f\n",
              label.c_str(), errors.luminance.size(), 100 * median, 100 * p99, delta_e_99);
  EXPECT_LE(median, times * kMedianLimit) << label;
  EXPECT_LE(p99, times * kPercentile99Limit) << label;
  EXPECT_LE(delta_e_99, times * kDeltaE99Limit) << label;
}

class LargeSizeAccuracy : public testing::TestWithParam<int> {};

TEST_P(LargeSizeAccuracy, AgreesWithTheExactReference) {
  const int size = GetParam();
  const test::BinsPitchCase c(size, size);
  const auto& observer = color_matching_functions("cie1931-2deg");
  std::vector<exact::SpectralTable> tables;
  for (const char* name : kLamps) tables.push_back(test::table_of(lamp_of(name)));
  const auto pixels = exact::spread_pixels(size, size, kPixels, 0.5, size * std::sqrt(0.5));
  const auto expected =
      exact::xyz_at(c.aperture, c.request(pixels), test::tables_of(observer), tables);
  const FarField field = c.field(0);
  for (std::size_t i = 0; i < std::size(kLamps); ++i) {
    const XyzImage found =
        spectral_integral(field, c.grid, lamp_of(kLamps[i]), observer, c.range, 0, {});
    expect_small(test::PixelErrors(found, pixels, expected.xyz[i]),
                 std::to_string(size) + ' ' + kLamps[i]);
  }
}

/// Along a ray an opening ten times as long as wide has detail that its far field's rows, in the
/// one direction, are too few for.
TEST(LargeSizeAccuracyOfALongOpening, AgreesWithTheExactReference) {
  constexpr int kSize = 500;
  constexpr double kWidth_mm = 8;
  Aperture opening{Image<float>(900, 90, 1.0f), kWidth_mm};
  const PixelGrid grid{kSize, kSize, 380e-6 / kWidth_mm};
  const WavelengthRange range{380, 780};
  const auto& observer = color_matching_functions("cie1931-2deg");
  const Spectrum lamp = *find_lamp("A");
  const auto pixels = exact::spread_pixels(kSize, kSize, kPixels, 0.5, kSize * std::sqrt(0.5));
  const auto expected =
      exact::xyz_at(opening, {kSize, kSize, grid.pitch_rad, pixels, range.lo_nm, range.hi_nm},
                    test::tables_of(observer), {test::table_of(lamp)});
  const FarField field = far_field(opening, far_field_request(0.1 * kWidth_mm, grid, range));
  const XyzImage found = spectral_integral(field, grid, lamp, observer, range, 0, {});
  // Hard, straight edges: all of the detail is at the very ends of what the samples hold.
  expect_small(test::PixelErrors(found, pixels, expected.xyz[0]), "long opening A", 2.2);
}

INSTANTIATE_TEST_SUITE_P(Sizes, LargeSizeAccuracy, testing::Values(1024, 4096),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace glare
