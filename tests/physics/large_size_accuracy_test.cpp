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

constexpr double kMedianLimit = 0.0005, kPercentile99Limit = 0.004, kDeltaE99Limit = 0.2;

constexpr int kPixels = 2000;

const char* const kLamps[] = {"HP5", "FL11", "lines"};

Spectrum lamp_of(const std::string& name) {
  return name == "lines" ? test::lamp_with_narrow_lines() : *find_lamp(name);
}

void expect_small(const test::PixelErrors& errors, const std::string& label) {
  const double median = test::percentile(errors.luminance, 0.5);
  const double p99 = test::percentile(errors.luminance, 0.99);
  const double delta_e_99 = test::percentile(errors.delta_e, 0.99);
  std::printf("%-18s %zu px  luminance: median %.4f %%, 99th %.4f %%;  CIEDE2000: 99th %.4f\n",
              label.c_str(), errors.luminance.size(), 100 * median, 100 * p99, delta_e_99);
  EXPECT_LE(median, kMedianLimit) << label;
  EXPECT_LE(p99, kPercentile99Limit) << label;
  EXPECT_LE(delta_e_99, kDeltaE99Limit) << label;
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

INSTANTIATE_TEST_SUITE_P(Sizes, LargeSizeAccuracy, testing::Values(1024, 4096),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace glare
