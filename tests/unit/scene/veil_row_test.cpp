#include "glare/scene/veil_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/every_target.h"

namespace glare {
namespace {

class VeilRowTargets : public test::EveryTarget {};
INSTANTIATE_TEST_SUITE_P(EveryTarget, VeilRowTargets, test::every_target(), test::target_name);

constexpr int kWidth = 60, kHeight = 50;
constexpr int kCount = 37;  // Whole vectors and a rest.

KernelGrid grid_of(double softness) {
  KernelGrid grid;
  constexpr int kBorder = KernelGrid::kBorder;
  grid.width = kWidth;
  grid.height = kHeight;
  grid.axis_column = 30;
  grid.axis_row = 25;
  grid.pitch_rad = 1e-3;
  grid.softness = softness;
  grid.rgba.assign(4 * kWidth * kHeight, 0.f);
  for (int y = kBorder; y < kHeight - kBorder; ++y)
    for (int x = kBorder; x < kWidth - kBorder; ++x)
      for (int k = 0; k < 3; ++k)
        grid.rgba[static_cast<std::size_t>(4 * (y * kWidth + x) + k)] =
            static_cast<float>(2 + k + std::sin(0.9 * x) * std::cos(0.8 * y));
  return grid;
}

/// A row near the axis of a picture whose pixels are `width_px` of the grid wide; from beyond the
/// grid's left border to beyond its right one. So near the axis sines are tangents within 3e-4 of a
/// pixel.
VeilRow row_of(double width_px) {
  const double pixel = 1e-3 * width_px, left = -0.5 * kCount * pixel - 0.3e-3, down = 4.3e-3;
  return {{left, pixel, 0},
          {down, 0, pixel},
          {1e3 * left, 1e3 * pixel, 0},
          {1e3 * down, 0, 1e3 * pixel},
          {1, 0, 0}};
}

/// The share of the box from `begin` to `end` that falls on pixel k, whose sides are blended over
/// `softness`; by a fine sum.
double share(double begin, double end, int k, double softness) {
  double sum = 0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    const double away = std::abs(begin + (end - begin) * (i + 0.5) / kSteps - k);
    sum += softness > 0 ? std::clamp((0.5 - away) / softness + 0.5, 0.0, 1.0) : away < 0.5;
  }
  return sum / kSteps;
}

double plain_mean(const KernelGrid& grid, double column, double row, double width, int channel) {
  double sum = 0;
  for (int y = 0; y < kHeight; ++y) {
    if (std::abs(y - row) > 6) continue;
    const double down = share(row - width / 2, row + width / 2, y, grid.softness);
    for (int x = 0; down > 0 && x < kWidth; ++x)
      if (std::abs(x - column) < 6)
        sum += down * share(column - width / 2, column + width / 2, x, grid.softness) *
               grid.rgba[static_cast<std::size_t>(4 * (y * kWidth + x) + channel)];
  }
  return sum;
}

class Veil {
 public:
  Veil(const KernelGrid& grid, const VeilRow& row, float lux) : values_(3 * (kCount + 1), 0.5f) {
    float* const first = values_.data();
    add_veil(grid, row, kCount, lux, {first, first + kCount + 1, first + 2 * (kCount + 1)});
  }
  float operator()(int i, int channel) const {
    return values_[static_cast<std::size_t>(channel * (kCount + 1) + i)];
  }

 private:
  std::vector<float> values_;
};

TEST_P(VeilRowTargets, AddTheMeanOverEachPixel) {
  struct Case {
    double width_px, softness;
  };
  for (const Case& c : {Case{0.3, 0.7}, Case{1, 0}, Case{1.9, 0}, Case{2.8, 0}, Case{5.2, 0}}) {
    const KernelGrid grid = grid_of(c.softness);
    const VeilRow row = row_of(c.width_px);
    const Veil veil(grid, row, 3);
    for (int i = 0; i < kCount; ++i) {
      const double column = 30 + row.column.start + i * row.column.step;
      for (int k = 0; k < 3; ++k) {
        const double expected = 0.5 + 3 * plain_mean(grid, column, 25 + 4.3, c.width_px, k);
        // The fine sum's steps, and the sines: 5e-3 and 3e-3 of a pixel's weight of up to 5.
        EXPECT_NEAR(veil(i, k), expected, 0.04) << c.width_px << ' ' << i;
      }
    }
    for (int k = 0; k < 3; ++k) EXPECT_EQ(veil(kCount, k), 0.5f);  // Not touched.
  }
}

TEST_P(VeilRowTargets, AddNothingBehindTheLamp) {
  VeilRow row = row_of(1);
  row.forward = {-1, 0, 0};
  const Veil veil(grid_of(0), row, 3);
  for (int i = 0; i < kCount; ++i) EXPECT_EQ(veil(i, 1), 0.5f);
}

}  // namespace
}  // namespace glare
