#include "glare/template/grid_means.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "glare/template/resampled.h"
#include "support/templates.h"

namespace glare {
namespace {

/// A bright pixel in four is a thousand times the others; signs as the bool says.
Image<float> random_picture(int width, int height, bool with_signs) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  return test::picture(width, height, [&](int, int) {
    const double value = uniform(generator) * (uniform(generator) < 0.25 ? 1000 : 1);
    return with_signs && uniform(generator) < 0.3 ? -value : value;
  });
}

/// Grids that cover the picture.
std::array<GridAxis, 2> covering(const Image<float>& picture, double ratio_x, double ratio_y,
                                 double shift_x = 0, double shift_y = 0) {
  return {{{covering_size(picture.width(), ratio_x, shift_x), ratio_x, shift_x},
           {covering_size(picture.height(), ratio_y, shift_y), ratio_y, shift_y}}};
}

Image<float> means(const Image<float>& picture, const std::array<GridAxis, 2>& axes,
                   int threads = 1) {
  return grid_means(picture, axes[0], axes[1], threads);
}

double sum(const Image<float>& image) {
  double result = 0;
  for (const float value : image.values()) result += value;
  return result;
}

/// Right and down from the axis' pixel.
std::array<double, 2> center_of_light(const Image<float>& picture) {
  double all = 0, x_moment = 0, y_moment = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const double light = picture(x, y);
      all += light;
      x_moment += light * (x - picture.width() / 2);
      y_moment += light * (y - picture.height() / 2);
    }
  return {x_moment / all, y_moment / all};
}

/// Along one axis, in double precision: the light before each of the new pixels' borders.
std::vector<double> slow_means(const std::vector<double>& v, const GridAxis& axis) {
  const int n = static_cast<int>(v.size());
  const auto at = [&](int i) { return v[static_cast<std::size_t>(std::clamp(i, 0, n - 1))]; };
  const auto density = [&](int i) {  // Before pixel i.
    if (i == 0 || i == n) return at(i);
    const double b = at(i - 1), c = at(i), least = std::min(std::abs(b), std::abs(c));
    if (b * c <= 0) return 0.0;
    const double sign = b > 0 ? 1 : -1, largest = std::max(std::abs(b), std::abs(c));
    const double smooth = sign * (7 * (b + c) - (at(i - 2) + at(i + 1))) / 12;
    return sign * std::clamp(smooth, least, std::min(largest, 2 * least));
  };
  const auto light_before = [&](double x) {
    double light = 0;
    int i = 0;
    for (; i + 1 <= x && i < n; ++i) light += at(i);
    if (i == n) return light;
    const double t = std::max(x - i, 0.0), a = density(i), b = density(i + 1), m = at(i);
    return light + a * t + (3 * m - 2 * a - b) * t * t + (a + b - 2 * m) * t * t * t;
  };
  std::vector<double> result;
  for (int i = 0; i < axis.pixels; ++i) {
    const double middle = (i - axis.pixels / 2 - axis.shift_px) * axis.pitch_ratio + n / 2 + 0.5;
    result.push_back((light_before(middle + axis.pitch_ratio / 2) -
                      light_before(middle - axis.pitch_ratio / 2)) /
                     axis.pitch_ratio);
  }
  return result;
}

using Rows = std::vector<std::vector<double>>;

Rows transposed(const Rows& rows) {
  Rows result(rows[0].size(), std::vector<double>(rows.size()));
  for (std::size_t y = 0; y < rows.size(); ++y)
    for (std::size_t x = 0; x < rows[0].size(); ++x) result[x][y] = rows[y][x];
  return result;
}

Rows slow_means(const Image<float>& picture, const std::array<GridAxis, 2>& axes) {
  Rows rows;
  for (int y = 0; y < picture.height(); ++y)
    rows.emplace_back(picture.row(y).begin(), picture.row(y).end());
  for (const GridAxis& axis : axes) {
    for (auto& row : rows) row = slow_means(row, axis);
    rows = transposed(rows);
  }
  return rows;
}

TEST(GridMeans, AreTheSameToTheLastBitAtARatioOf1) {
  for (const auto& [width, height] : {std::array{37, 20}, {20, 37}, {1, 1}, {2, 5}}) {
    const Image<float> picture = random_picture(width, height, true);
    const Image<float> same = grid_means(picture, {width, 1}, {height, 1});
    EXPECT_TRUE(std::ranges::equal(same.values(), picture.values())) << width << " x " << height;
  }
}

TEST(GridMeans, AreThoseOfTheSlowFormula) {
  const Image<float> picture = random_picture(33, 20, true);
  for (const double ratio : {0.17, 0.5, 0.93, 1., 1.37, 3.3, 50.})
    for (const double shift : {0., 0.31, -0.5}) {
      const auto axes = covering(picture, ratio, 0.8 * ratio, shift, -0.4 * shift);
      const Image<float> fast = means(picture, axes);
      const Rows slow = slow_means(picture, axes);
      for (int y = 0; y < fast.height(); ++y)
        for (int x = 0; x < fast.width(); ++x)
          // Single precision, of neighbours up to 1000.
          EXPECT_NEAR(fast(x, y), slow[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)],
                      1e-3)
              << ratio << ", " << shift;
    }
}

TEST(GridMeans, KeepTheLightAtAnyRatio) {
  const Image<float> picture = random_picture(40, 27, false);
  for (double ratio = 0.17; ratio < 6; ratio *= 1.093)
    for (const double shift : {0., 0.2, -0.5}) {
      const auto axes = covering(picture, ratio, 1.3 * ratio, shift, shift / 3);
      // Sums of values in single precision.
      EXPECT_NEAR(sum(means(picture, axes)) * 1.3 * ratio * ratio / sum(picture), 1, 1e-6) << ratio;
    }
}

TEST(GridMeans, EachOldPixelKeepsItsMean) {
  const Image<float> picture = random_picture(15, 12, true);
  const Image<float> finer = means(picture, covering(picture, 1. / 3, 1. / 3));
  const int x0 = finer.width() / 2 - 1, y0 = finer.height() / 2 - 1;  // Of the axis' pixel.
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 15; ++x) {
      double mean = 0;
      for (int i = 0; i < 9; ++i)
        mean += finer(x0 + 3 * (x - 7) + i % 3, y0 + 3 * (y - 6) + i / 3) / 9.;
      EXPECT_NEAR(mean, picture(x, y), 1e-3) << x << ", " << y;  // Of values up to 1000.
    }
}

TEST(GridMeans, NoLightIsNegativeWhereNoneWas) {
  Image<float> picture = random_picture(40, 30, false);
  for (int x = 0; x < 40; x += 3) picture(x, 11) = 0;
  for (const double ratio : {0.03, 0.17, 0.41, 1., 1.9})
    for (const double shift : {0., 0.123}) {
      const Image<float> other = means(picture, covering(picture, ratio, ratio, shift, shift));
      EXPECT_GE(*std::ranges::min_element(other.values()), 0) << ratio;
    }
}

TEST(GridMeans, MoveTheCentreOfLightByTheShift) {
  // Wider than a pixel of either grid, off the axis and not symmetric.
  for (const double ratio : {0.3, 0.77, 1., 1.6, 3.1})
    for (const double shift : {-0.5, -0.2, 0., 0.13, 0.37, 0.5}) {
      const double sigma = 2.2 * std::max(1., ratio);
      const Image<float> picture = test::picture(81, 64, [&](int x, int y) {
        const double u = (x - 40 - 1.3) / sigma, v = (y - 32 + 0.6) / sigma / 1.4;
        return std::exp(-0.5 * (u * u + v * v) + 0.1 * u);
      });
      const Image<float> other = means(picture, covering(picture, ratio, ratio, shift, -shift));
      const auto before = center_of_light(picture), after = center_of_light(other);
      EXPECT_NEAR(after[0], before[0] / ratio + shift, 0.01) << ratio << ", " << shift;
      EXPECT_NEAR(after[1], before[1] / ratio - shift, 0.01) << ratio << ", " << shift;
    }
}

TEST(GridMeans, AreTheSameForAnyNumberOfThreadsAndAnyCut) {
  const Image<float> picture = random_picture(100, 90, true);
  auto axes = covering(picture, 0.61, 0.83, 0.2, 0.1);
  const Image<float> one = means(picture, axes, 1), four = means(picture, axes, 4);
  EXPECT_TRUE(std::ranges::equal(one.values(), four.values()));
  const int left = one.width() / 2 - 10, top = one.height() / 2 - 15;
  axes[0].pixels = 21;
  axes[1].pixels = 31;
  const Image<float> cut = means(picture, axes);
  EXPECT_TRUE(std::ranges::equal(cut.values(), test::cropped(one, left, top, 21, 31).values()));
}

TEST(GridMeans, BeyondThePictureThereIsNothing) {
  const Image<float> picture = random_picture(9, 9, false);
  const Image<float> wide = grid_means(picture, {31, 1}, {31, 1});
  EXPECT_EQ(sum(wide), sum(test::cropped(wide, 11, 11, 9, 9)));
  EXPECT_EQ(sum(grid_means(picture, {1, 0.1, 200}, {3, 1})), 0);
}

}  // namespace
}  // namespace glare
