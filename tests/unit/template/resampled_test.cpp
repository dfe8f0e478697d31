#include "glare/template/resampled.h"

#include <gtest/gtest.h>

#include <cmath>

#include "glare/base/error.h"

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

}  // namespace
}  // namespace glare
