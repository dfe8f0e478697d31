#include "glare/aperture/eye/lens_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "glare/base/error.h"
#include "glare/base/image.h"

namespace glare {
namespace {

constexpr double width_mm = 6;

LensParameters only_fibres(double modulation) {
  LensParameters parameters;
  parameters.fibre_modulation = modulation;
  parameters.suture_contrast = 0;
  return parameters;
}

LensParameters only_sutures() {
  LensParameters parameters;
  parameters.fibre_modulation = 0;
  parameters.suture_contrast = 1;
  return parameters;
}

Image<float> drawn(const LensLayer& layer, int size) {
  Image<float> image(size, size);
  std::ranges::fill(image.values(), 1.0f);
  for (int y = 0; y < size; ++y)
    layer.draw_row({size, width_mm / size}, y, {0, size}, image.row(y));
  return image;
}

double covered_mm2(const Image<float>& image) {
  double sum = 0;
  for (const float t : image.values()) sum += 1 - t;
  return sum * width_mm * width_mm / static_cast<double>(image.values().size());
}

struct Difference {
  double max = 0, mean = 0;
};

Difference difference_at_half_resolution(const LensLayer& layer, int size) {
  const Image<float> fine = drawn(layer, 2 * size), coarse = drawn(layer, size);
  Difference result;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const float average = 0.25f * (fine(2 * x, 2 * y) + fine(2 * x + 1, 2 * y) +
                                     fine(2 * x, 2 * y + 1) + fine(2 * x + 1, 2 * y + 1));
      const double difference = std::abs(average - coarse(x, y));
      result.max = std::max(result.max, difference);
      result.mean += difference / (1.0 * size * size);
    }
  return result;
}

TEST(LensFibres, AverageToOneMinusHalfTheModulation) {
  for (const int size : {64, 501, 2000}) {
    const Image<float> image = drawn(LensLayer(only_fibres(0.4), 1), size);
    double sum = 0;
    for (const float t : image.values()) {
      ASSERT_GE(t, 0.6f - 1e-6f);
      ASSERT_LE(t, 1 + 1e-6f);
      sum += t;
    }
    // Whole periods around each circle; the square cuts some near its corners.
    EXPECT_NEAR(sum / (1.0 * size * size), 0.8, 1e-4);
  }
}

TEST(LensFibres, HaveThePitchAskedFor) {
  // Along the vertical through (2.5 mm, 0) fibres are crossed at right angles: over 0.4 mm their
  // pitch is that of the rings around a radius of 2.5 mm, within half the pitch's variation.
  LensParameters parameters = only_fibres(1);
  parameters.fibre_pitch_variation = 0.1;
  const Image<float> image = drawn(LensLayer(parameters, 1), 6000);  // 1 um.
  const int column = 3000 + 2500;
  int crossings = 0;
  for (int y = 2800; y < 3200; ++y)
    if ((image(column, y) < 0.5f) != (image(column, y + 1) < 0.5f)) ++crossings;
  EXPECT_NEAR(0.5 * crossings, 400 / 10.85, 0.06 * 400 / 10.85 + 0.5);
}

TEST(LensFibres, AverageOfFourPixelsIsThePictureAtHalfTheResolution) {
  // A ring's weight is taken at each pixel's centre; it bends most where its soft edge, 0.03 mm
  // wide at the narrowest, begins and ends: a few percent of the modulation there.
  const LensLayer layer(only_fibres(0.2), 1);
  for (const int size : {1000, 3000}) {
    const Difference difference = difference_at_half_resolution(layer, size);
    EXPECT_LT(difference.max, 0.05 * 0.2);
    EXPECT_LT(difference.mean, 0.001 * 0.2);
  }
}

TEST(LensFibres, BeginOutsideTheirInnerRadius) {
  const Image<float> image = drawn(LensLayer(only_fibres(0.4), 1), 1500);  // 4 um.
  for (int y = 0; y < 1500; ++y)
    for (int x = 0; x < 1500; ++x)
      if (std::hypot(x - 749.5, y - 749.5) * 0.004 < 1.49) {
        ASSERT_FLOAT_EQ(image(x, y), 0.8f);
      }
}

TEST(LensSutures, CoverTheirLengthTimesTheirWidth) {
  LensParameters parameters = only_sutures();
  parameters.suture_branches = 1;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const double coarse = covered_mm2(drawn(LensLayer(parameters, seed), 700));
    const double fine = covered_mm2(drawn(LensLayer(parameters, seed), 4000));
    // Half as wide at the end: three quarters of the width on average; 70 to 100 % of the length.
    EXPECT_GT(fine, 0.7 * 2.5 * 0.016 * 0.75);
    EXPECT_LT(fine, 1.01 * 2.5 * 0.016 * 0.75);
    EXPECT_NEAR(coarse / fine, 1, 0.02);  // Of 8.6 um: ends are not exact.
  }
}

TEST(Lens, IsTheSameForTheSameSeedOnly) {
  const auto picture = [](std::uint64_t seed) { return drawn(LensLayer({}, seed), 1200); };
  EXPECT_TRUE(std::ranges::equal(picture(1).values(), picture(1).values()));
  EXPECT_FALSE(std::ranges::equal(picture(1).values(), picture(2).values()));
}

TEST(Lens, ColumnsThatAreNotOpenStay) {
  std::vector<float> row(1000, 1.0f);
  LensLayer({}, 1).draw_row({1000, width_mm / 1000}, 480, {300, 700}, row);
  EXPECT_EQ(std::ranges::count(row.begin(), row.begin() + 300, 1.0f), 300);
  EXPECT_EQ(std::ranges::count(row.begin() + 700, row.end(), 1.0f), 300);
  EXPECT_EQ(std::ranges::count(row.begin() + 300, row.begin() + 700, 1.0f), 0);
}

TEST(Lens, RefusesWhatIsOutOfRange) {
  const auto refused = [](auto member, auto value) {
    LensParameters parameters;
    parameters.*member = value;
    EXPECT_THROW(LensLayer(parameters, 1), OptionError);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused(&LensParameters::fibre_pitch_um, 4.0);
  refused(&LensParameters::fibre_pitch_um, nan);
  refused(&LensParameters::fibre_pitch_variation, 0.01);
  refused(&LensParameters::fibre_zone_inner_mm, 0.4);
  refused(&LensParameters::fibre_zone_outer_mm, 1.5);
  refused(&LensParameters::fibre_modulation, 1.1);
  refused(&LensParameters::suture_branches, -1);
  refused(&LensParameters::suture_branches, 49);
  refused(&LensParameters::suture_length_mm, 0.0);
  refused(&LensParameters::suture_width_um, 201.0);
  refused(&LensParameters::suture_contrast, -0.1);
}

}  // namespace
}  // namespace glare
