#include "glare/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "glare/base/error.h"

namespace glare {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

TEST(Camera, SpansItsFieldFromBorderToBorder) {
  const Camera camera{1920, 1080, 70};
  const Vector3 left = camera.direction_of(-0.5, 539.5), right = camera.direction_of(1919.5, 539.5);
  EXPECT_NEAR(std::atan2(right[0], right[2]) / kDegree, 35, 1e-12);
  EXPECT_NEAR(std::atan2(left[0], left[2]) / kDegree, -35, 1e-12);
}

TEST(Camera, LooksAlongTheMiddleWithUpAbove) {
  const Camera camera{5, 4, 40};
  const Vector3 middle = camera.direction_of(2, 1.5);
  EXPECT_EQ(middle, (Vector3{0, 0, 1}));
  EXPECT_GT(camera.direction_of(2, 0)[1], 0);
  EXPECT_GT(camera.direction_of(4, 1.5)[0], 0);
}

TEST(Camera, FindsTheDirectionOfAPlaceAgain) {
  const Camera camera{1920, 1080, 70};
  for (const double column : {-300.25, 0., 959.5, 1800.75})
    for (const double row : {-20., 12.5, 1079.}) {
      Vector3 direction = camera.direction_of(column, row);
      EXPECT_NEAR(std::hypot(direction[0], direction[1], direction[2]), 1, 1e-12);
      for (double& x : direction) x *= 7;  // Of any length.
      const auto place = camera.pixel_of(direction).value();
      EXPECT_NEAR(place[0], column, 1e-9);
      EXPECT_NEAR(place[1], row, 1e-9);
    }
}

TEST(Camera, KnowsNoPlaceBehindTheViewer) {
  const Camera camera{1920, 1080, 70};
  EXPECT_FALSE(camera.pixel_of({1, 0, 0}));
  EXPECT_FALSE(camera.pixel_of({0, 0, -1}));
}

TEST(Camera, IsRefusedOutOfRange) {
  EXPECT_NO_THROW(require_valid(Camera{1, 1, 179}));
  EXPECT_THROW(require_valid(Camera{0, 1, 70}), OptionError);
  EXPECT_THROW(require_valid(Camera{1, 65537, 70}), OptionError);
  EXPECT_THROW(require_valid(Camera{1, 1, 0}), OptionError);
  EXPECT_THROW(require_valid(Camera{1, 1, 180}), OptionError);
  EXPECT_THROW(require_valid(Camera{1, 1, std::numeric_limits<double>::quiet_NaN()}), OptionError);
}

}  // namespace
}  // namespace glare
