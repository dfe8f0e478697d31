#include "glare/convolution/roll_off.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "glare/base/error.h"
#include "support/templates.h"

namespace glare {
namespace {

/// 31 x 21 pixels of equal shares, with 0.3, 0.4 and 0.5 of the light kept.
PixelKernel flat_kernel() {
  PixelKernel kernel;
  for (std::size_t k = 0; k < 3; ++k) {
    kernel.kept[k] = 0.3 + 0.1 * static_cast<double>(k);
    kernel.captured[k] = 1 - kernel.kept[k];
    kernel.channels[k] =
        test::picture(31, 21, [&](int, int) { return kernel.captured[k] / (31 * 21); });
  }
  return kernel;
}

double sum(const Image<float>& image) {
  double total = 0;
  for (const float value : image.values()) total += value;
  return total;
}

TEST(RollOff, KeepsTheLight) {
  const PixelKernel before = flat_kernel();
  PixelKernel kernel = before;
  const auto taken = roll_off(kernel, {15, 10, 0.25});
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_GT(taken[k], 0);
    EXPECT_NEAR(sum(kernel.channels[k]), kernel.captured[k], 1e-7);  // Single precision.
    EXPECT_DOUBLE_EQ(kernel.captured[k] + taken[k], before.captured[k]);
    EXPECT_DOUBLE_EQ(kernel.kept[k] - taken[k], before.kept[k]);
  }
}

TEST(RollOff, IsZeroFromTheRadiusOnAndNothingInside) {
  const PixelKernel before = flat_kernel();
  PixelKernel kernel = before;
  roll_off(kernel, {15, 10, 0.25});
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 31; ++x) {
      const double r = std::hypot((x - 15) / 15., (y - 10) / 10.);
      const float value = kernel.channels[1](x, y), flat = before.channels[1](x, y);
      if (r >= 1)
        EXPECT_EQ(value, 0);
      else if (r <= 0.75)
        EXPECT_EQ(value, flat);
      else
        EXPECT_TRUE(value > 0 && value < flat) << x << " " << y;
    }
  // In the middle of the fade, at r = 0.875, it is half; here at 0.8667 and 0.9333.
  EXPECT_NEAR(kernel.channels[1](28, 10) / before.channels[1](28, 10),
              std::pow(std::cos(std::numbers::pi / 2 * (13 / 15. - 0.75) / 0.25), 2), 1e-6);
  EXPECT_NEAR(kernel.channels[1](1, 10) / before.channels[1](1, 10),
              std::pow(std::cos(std::numbers::pi / 2 * (14 / 15. - 0.75) / 0.25), 2), 1e-6);
}

TEST(RollOff, RefusesWhatMakesNoSense) {
  PixelKernel kernel = flat_kernel();
  EXPECT_THROW(roll_off(kernel, {0, 10, 0.25}), OptionError);
  EXPECT_THROW(roll_off(kernel, {15, 0, 0.25}), OptionError);
  EXPECT_THROW(roll_off(kernel, {15, 10, -0.1}), OptionError);
  EXPECT_THROW(roll_off(kernel, {15, 10, std::nan("")}), OptionError);
}

}  // namespace
}  // namespace glare
