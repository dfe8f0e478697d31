#include "glare/scene/headlamp_frame.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/slow_veil.h"

namespace glare {
namespace {

constexpr double kPitch_rad = 1e-3;

GlareTemplate slope() {
  GlareTemplate t;
  t.color_space = xyz_color_space();
  t.pixel_pitch_rad = kPitch_rad;
  t.per_steradian = 0.5;
  for (auto& channel : t.channels) {
    channel = Image<float>(401, 401);
    for (int y = 0; y < 401; ++y)
      for (int x = 0; x < 401; ++x)
        channel(x, y) = static_cast<float>(1 / (1 + 0.01 * std::hypot(x - 200, y - 200)));
  }
  return t;
}

std::shared_ptr<const LuminousIntensityDistribution> even_beam(float candela) {
  return std::make_shared<const LuminousIntensityDistribution>(
      PhotometricType::a, std::vector<double>{-90, 90}, std::vector<double>{-90, 90},
      Image<float>(2, 2, candela));
}

TEST(HeadlampFrame, HasEachLampsLuxTimesTheTemplateOverTheBackground) {
  const Camera camera{320, 181, 30};
  Picture background;
  background.color_space = xyz_color_space();
  for (auto& channel : background.channels) channel = Image<float>(320, 181, 2.f);
  const GlareTemplate t = slope();
  const GlareKernel kernel(t, camera, background.color_space);
  const std::array<Headlamp, 2> lamps = {{{even_beam(8000), {{-0.6, -0.5, 40}, {}}, 1, kernel},
                                          {even_beam(8000), {{0.6, -0.5, 40}, {}}, 0.5, kernel}}};
  Picture frame;
  const auto lights = make_headlamp_frame(background, camera, lamps, frame);

  const double square = 40 * 40 + 0.6 * 0.6 + 0.5 * 0.5, cosine = 40 / std::sqrt(square);
  EXPECT_NEAR(lights[0].illuminance_lux, 8000 / square * cosine, 1e-9);
  EXPECT_NEAR(lights[1].illuminance_lux, 4000 / square * cosine, 1e-9);
  for (int y = 3; y < 181; y += 29)
    for (int x = 5; x < 320; x += 31) {
      double expected = 2;
      for (const LightAtEye& light : lights)
        expected += light.illuminance_lux * 0.5 * test::slow_veil(t, camera, light.direction, x, y);
      EXPECT_NEAR(frame.channels[1](x, y) / expected, 1, 0.005);
    }
}

TEST(HeadlampFrame, UsesItsMemoryAgain) {
  const Camera camera{32, 18, 30};
  Picture background, frame;
  for (auto& channel : background.channels) channel = Image<float>(32, 18, 2.f);
  make_headlamp_frame(background, camera, {}, frame);
  const float* const memory = frame.channels[0].values().data();
  frame.channels[0](3, 3) = 7;
  make_headlamp_frame(background, camera, {}, frame);
  EXPECT_EQ(frame.channels[0].values().data(), memory);
  EXPECT_EQ(frame.channels[0](3, 3), 2);
}

}  // namespace
}  // namespace glare
