#include "glare/template/resampled.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "glare/base/error.h"
#include "glare/spectrum/lamps.h"
#include "support/templates.h"

namespace glare {
namespace {

Image<float> bumps(int width, int height) {
  Image<float> out(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      out(x, y) = static_cast<float>(1 + std::sin(0.7 * x) * std::cos(1.1 * y));
  return out;
}

double sum(const Image<float>& image) {
  double result = 0;
  for (const float v : image.values()) result += v;
  return result;
}

TEST(Resampled, IsTheSameAtTheSamePitch) {
  const Image<float> picture = bumps(20, 13);
  const Image<float> same = area_means(picture, 1, 20, 13);
  for (int y = 0; y < 13; ++y)
    for (int x = 0; x < 20; ++x) EXPECT_EQ(same(x, y), picture(x, y));
}

TEST(Resampled, KeepsTheLight) {
  const Image<float> picture = bumps(20, 13);
  for (const double ratio : {0.23, 0.5, 1.7, 3., 8.4}) {
    const Image<float> other =
        area_means(picture, ratio, covering_size(20, ratio), covering_size(13, ratio));
    EXPECT_NEAR(sum(other) * ratio * ratio / sum(picture), 1, 1e-5) << ratio;  // Single precision.
  }
}

TEST(Resampled, IsTheMeanAboutTheSameAxis) {
  const Image<float> picture = bumps(21, 21);
  const Image<float> thirds = area_means(picture, 3, 7, 7);
  double mean = 0;
  for (int y = 12; y < 15; ++y)
    for (int x = 9; x < 12; ++x) mean += picture(x, y) / 9.;
  EXPECT_NEAR(thirds(3, 4), mean, 1e-6);  // The axis' pixel, and the one below.
  const Image<float> finer = area_means(picture, 1 / 3., 63, 63);
  for (int i = -1; i <= 1; ++i) EXPECT_NEAR(finer(31 + 3 + i, 31), picture(11, 10), 1e-6);
}

TEST(Resampled, CoversAllWithAnOddNumberOfPixels) {
  EXPECT_EQ(covering_size(21, 3), 7);
  EXPECT_EQ(covering_size(21, 1), 21);
  EXPECT_EQ(covering_size(20, 1), 21);
  EXPECT_EQ(covering_size(21, 100), 1);
  EXPECT_EQ(covering_size(23, 3), 9);
}

TEST(Resampled, TemplatesStayPerSteradian) {
  GlareTemplate t;
  t.color_space = xyz_color_space();
  for (auto& channel : t.channels) channel = bumps(21, 21);
  t.pixel_pitch_rad = 1e-4;
  t.per_steradian = 50;
  t.captured_energy = 50 * sum(t.channels[1]) * 1e-8;
  const GlareTemplate same = resampled(t, 3e-4, 7, 7);
  EXPECT_EQ(same.normalization, Normalization::absolute);
  EXPECT_EQ(same.pixel_pitch_rad, 3e-4);
  EXPECT_NEAR(sum(same.channels[1]) * 9e-8 * same.per_steradian, t.captured_energy,
              1e-5 * t.captured_energy);
  EXPECT_NEAR(same.captured_energy, t.captured_energy, 1e-5 * t.captured_energy);
  const GlareTemplate part = resampled(t, 3e-4, 3, 3);
  EXPECT_NEAR(part.captured_energy, sum(part.channels[1]) * 9e-8, 1e-5 * t.captured_energy);
  EXPECT_THROW(resampled(t, 0, 3, 3), OptionError);
  EXPECT_THROW(resampled(t, 1e-4, 0, 3), OptionError);
}

/// How far, in the middle and at most, a template's luminances are from the directly made one's,
/// of which pixels above 1e-5 of the brightest count.
std::array<double, 2> relative_errors(const Image<float>& image, const Image<float>& direct) {
  const float peak = *std::ranges::max_element(direct.values());
  std::vector<double> errors;
  for (std::size_t i = 0; i < direct.values().size(); ++i)
    if (const double value = direct.values()[i]; value > 1e-5 * peak)
      errors.push_back(std::abs(image.values()[i] / value - 1));
  std::ranges::sort(errors);
  return {errors[errors.size() / 2], errors.back()};
}

TEST(Resampled, IsNearTheTemplateMadeAtThatPitch) {
  // Median and largest error for a round pupil; squares of one value are farther off.
  struct Case {
    double ratio;
    int pixels;
    double median, largest;
  };
  const GlareTemplate t =
      make_template(test::small_pupil(), blackbody(5000), test::absolute_xyz(96, 96, 1e-4));
  for (const Case& c : {Case{0.5, 181, 0.01, 1.5}, {1.37, 65, 0.003, 0.5}, {2, 47, 0.001, 0.5}}) {
    const Image<float> direct =
        test::luminance_of(test::small_pupil(), blackbody(5000),
                           test::absolute_xyz(c.pixels, c.pixels, c.ratio * 1e-4));
    const auto errors =
        relative_errors(resampled(t, c.ratio * 1e-4, c.pixels, c.pixels).channels[1], direct);
    const auto of_squares =
        relative_errors(area_means(t.channels[1], c.ratio, c.pixels, c.pixels), direct);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(errors[k], 0.7 * of_squares[k]) << c.ratio;
    EXPECT_LT(errors[0], c.median) << c.ratio;
    EXPECT_LT(errors[1], c.largest) << c.ratio;
  }
}

}  // namespace
}  // namespace glare
