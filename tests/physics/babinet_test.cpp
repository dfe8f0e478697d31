// Babinet's principle: T of an open frame is T of a hole plus T of the frame without it. Wherever
// the frame itself sends no light, the hole and its complement send the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glare/glare.h"
#include "support/templates.h"

namespace glare {
namespace {

/// The frame without the hole.
Aperture complement(const Aperture& hole) {
  Aperture out = hole;
  for (float& t : out.transmittance.values()) t = 1 - t;
  return out;
}

TEST(Babinet, HoleAndScreenAgreeWhereTheFrameIsDark) {
  // An open frame of 128 samples is dark at every multiple of 1 / frame; transforms of 512 samples,
  // so at every fourth one. The hole's letter and wedge are put into 64 x 64 of them, for the same
  // transform by twice the padding.
  Aperture hole{Image<float>(128, 128), 4};
  const Aperture letter = test::lopsided({64, 64, 2});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) hole.transmittance(41 + x, 17 + y) = letter.transmittance(x, y);
  hole.transmittance(41, 17) = hole.transmittance(104, 80) = 1;
  const Aperture screen = complement(hole);
  FarFieldRequest request;
  request.max_frequency_x_per_mm = request.max_frequency_y_per_mm = 16;  // To the repetition.
  const FarField of_screen = far_field(screen, request);
  request.padding = 8;
  const FarField of_hole = far_field(hole, request);
  ASSERT_DOUBLE_EQ(of_hole.bin_x_per_mm, 1 / (512 * hole.pixel_mm()));
  ASSERT_DOUBLE_EQ(of_screen.bin_x_per_mm, of_hole.bin_x_per_mm);
  ASSERT_EQ(of_screen.first_ky, of_hole.first_ky);

  double largest = 0, off = 0;
  for (int kx = 0; kx <= 256; kx += 4)
    for (int ky = -256; ky <= 256; ky += 4) {
      if (kx == 0 && ky == 0) continue;
      const double a = of_hole.energy_area_mm2 *
                       of_hole.intensity_mm2(ky - of_hole.first_ky, kx - of_hole.first_kx);
      const double b = of_screen.energy_area_mm2 *
                       of_screen.intensity_mm2(ky - of_screen.first_ky, kx - of_screen.first_kx);
      largest = std::max(largest, a);
      off = std::max(off, std::abs(a - b));
    }
  EXPECT_LT(off / largest, 2e-5);  // Single precision: the screen's sum is the far larger one.
}

TEST(Babinet, AHairsStreakIsThatOfASlitOfItsShape) {
  // A hair across a square pupil at 45 degrees. The square's own light keeps to its cross, and the
  // streak runs between its arms.
  const test::Frame frame{768, 768, 4};
  const Aperture slit = test::sampled(frame, [](const test::Place& at) {
    const double across = std::abs(at.x_mm - at.y_mm) / std::sqrt(2.0);
    const double along = std::abs(at.x_mm + at.y_mm) / std::sqrt(2.0);
    return std::clamp((0.05 - across) / 0.01, 0.0, 1.0) * std::clamp((1.5 - along) / 0.4, 0.0, 1.0);
  });
  const Aperture hair = complement(slit);
  const auto options = test::absolute_xyz(129, 129, 2e-4);
  const Spectrum lamp = *find_lamp("D65");
  const Image<float> of_slit = test::luminance_of(slit, lamp, options);
  const Image<float> of_hair = test::luminance_of(hair, lamp, options);
  for (int d = 8; d <= 40; d += 4) {
    const double a = of_slit(64 + d, 64 - d) * energy_area_mm2(slit);
    const double b = of_hair(64 + d, 64 - d) * energy_area_mm2(hair);
    // What the square sends there has some 1 % of the streak's amplitude.
    EXPECT_NEAR(b / a, 1, 0.03) << d;
  }
}

}  // namespace
}  // namespace glare
