#include "glare/photometry/intensity_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "glare/base/error.h"

namespace glare {
namespace {

using testing::ElementsAre;

TEST(IntensityGrid, ImagesHaveTheSkyAtTheTop) {
  Image<float> image(3, 2);
  for (int x = 0; x < 3; ++x) {
    image(x, 0) = static_cast<float>(10 + x);
    image(x, 1) = static_cast<float>(x);
  }
  const auto lamp = distribution_from_image(image, {{-50, 50}, {-15, 15}, 3, 2});
  EXPECT_EQ(lamp.type(), PhotometricType::a);
  EXPECT_THAT(lamp.horizontal_deg(), ElementsAre(-50, 0, 50));
  EXPECT_THAT(lamp.vertical_deg(), ElementsAre(-15, 15));
  EXPECT_EQ(lamp(-50, 15), 10);
  EXPECT_EQ(lamp(50, -15), 2);
  const Image<float> back = image_from_distribution(lamp);
  EXPECT_TRUE(std::ranges::equal(back.values(), image.values()));
}

TEST(IntensityGrid, ResampledTowardsTheVehiclesDirections) {
  Image<float> candela(2, 2);
  candela(1, 0) = candela(1, 1) = 100;
  const LuminousIntensityDistribution lamp(PhotometricType::b, {-40, 40}, {-30, 30}, candela);
  const IntensityGrid grid{{-20, 20}, {-10, 10}, 41, 3};
  const auto resampled = on_grid(lamp, grid, {.yaw_deg = 10});
  for (const double h : {-20.0, 3.0, 20.0})
    for (const double v : {-10.0, 10.0})
      EXPECT_NEAR(resampled(h, v),
                  lamp.towards(direction_from_angles(PhotometricType::a, h, v), {.yaw_deg = 10}),
                  1e-5);  // 32-bit floats.
  EXPECT_NEAR(resampled(10, 0), 50, 1e-5);
}

TEST(IntensityGrid, RefusesBadGrids) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(require_intensity_grid({{-180, 180}, {-90, 90}, 2, 65535}));
  EXPECT_THROW(require_intensity_grid({{-50, 50}, {-15, 15}, 1, 10}), OptionError);
  EXPECT_THROW(require_intensity_grid({{-50, 50}, {-15, 15}, 10, 65536}), OptionError);
  EXPECT_THROW(require_intensity_grid({{50, -50}, {-15, 15}, 10, 10}), OptionError);
  EXPECT_THROW(require_intensity_grid({{-50, nan}, {-15, 15}, 10, 10}), OptionError);
  EXPECT_THROW(require_intensity_grid({{-50, 50}, {-91, 15}, 10, 10}), OptionError);
  EXPECT_THROW(require_intensity_grid({{-200, 200}, {-15, 15}, 10, 10}), OptionError);
}

}  // namespace
}  // namespace glare
