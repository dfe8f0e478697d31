// Each program's kernel against its published contract (docs/kernels.md), and a picture convolved
// with it, as that program documents it, against `apply_glare`.
#include "glare/convolution/kernel_programs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "glare/base/error.h"
#include "glare/convolution/glare_filter.h"
#include "glare/convolution/pixel_kernel.h"
#include "support/templates.h"

namespace glare {
namespace {

constexpr double kPitch = 1e-3;

/// Lopsided and coloured, so that every mirror, shift and mixed channel shows: half of the light in
/// a spike, the rest in streaks that reach the border.
GlareTemplate lopsided_template(int width, int height) {
  GlareTemplate t;
  t.color_space = lin_rec709_color_space();
  for (std::size_t k = 0; k < 3; ++k)
    t.channels[k] = test::picture(width, height, [&](int x, int y) {
      const double u = x - width / 2, v = y - height / 2, r2 = u * u + v * v;
      return 20 * std::exp(-r2) + (1 + 0.5 * std::cos(3 * std::atan2(v, u) + 0.7)) /
                                      (1 + r2 / (2. + static_cast<double>(k)));
    });
  double sum = 0;
  for (const float value : t.channels[1].values()) sum += value;
  t.pixel_pitch_rad = kPitch;
  t.per_steradian = 0.8 / (sum * kPitch * kPitch);
  t.light_xyz = t.color_space.white_xyz();
  return t;
}

/// A dim gradient with four bright points, one of them in a corner.
Picture small_scene() {
  Picture picture;
  for (std::size_t k = 0; k < 3; ++k) {
    picture.channels[k] = test::picture(26, 19, [&](int x, int y) {
      return 0.1 + 0.01 * x + 0.005 * y * static_cast<double>(k + 1);
    });
    picture.channels[k](0, 0) = 40;
    picture.channels[k](7, 12) = static_cast<float>(500 - 200. * static_cast<double>(k));
    picture.channels[k](20, 4) = static_cast<float>(90. + 60. * static_cast<double>(k));
    picture.channels[k](21, 4) = 11;
  }
  return picture;
}

double sum(const Image<float>& image) {
  double total = 0;
  for (const float value : image.values()) total += value;
  return total;
}

/// The plain double sum of a program's own convolution: spreading (convolution) or gathering the
/// values beside a pixel times the kernel's at the same places (correlation); then divided by
/// `divisor`. The axis is pixel (width / 2, height / 2), and beyond the border is black.
Image<double> convolved(const Image<float>& picture, const Image<float>& kernel, bool gathers,
                        double divisor) {
  Image<double> out(picture.width(), picture.height());
  const int sign = gathers ? 1 : -1;
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x) {
      double total = 0;
      for (int j = 0; j < kernel.height(); ++j)
        for (int i = 0; i < kernel.width(); ++i) {
          const int from_x = x + sign * (i - kernel.width() / 2);
          const int from_y = y + sign * (j - kernel.height() / 2);
          if (from_x < 0 || from_y < 0 || from_x >= out.width() || from_y >= out.height()) continue;
          total += double{picture(from_x, from_y)} * kernel(i, j);
        }
      out(x, y) = total / divisor;
    }
  return out;
}

Picture with_glare(Picture picture, const GlareTemplate& t) {
  const PixelKernel kernel = pixel_kernel(t, {kPitch, 1}, picture.color_space);
  apply_glare(picture, GlareFilter(kernel, picture.width(), picture.height()));
  return picture;
}

KernelImage image_for(const KernelProgram& program, const GlareTemplate& t, double roll_off_share) {
  KernelImageOptions options = program.options;
  options.roll_off_share = roll_off_share;
  return kernel_image(pixel_kernel(t, {kPitch, 1}, t.color_space), options);
}

/// Blender documents its node as gathering; the others spread.
bool gathers(const KernelProgram& program) { return std::string(program.name) == "blender"; }

/// Those that divide by the kernel's sum, and the one whose shader divides by what is told.
double divisor_of(const KernelProgram& program, const KernelImage& image, std::size_t k) {
  const std::string name = program.name;
  if (name == "unreal" || name == "blender" || name == "nuke")
    return sum(image.picture.channels[k]);
  return image.sum;
}

/// Half rounds the centre's share, up to 1, by 2^-12, and each other by 2^-12 of itself.
double rounding_of(const KernelProgram& program) { return program.options.half ? 2.5e-4 : 1e-6; }

TEST(KernelPrograms, FilesKeepTheContract) {
  for (const KernelProgram& program : kernel_programs())
    for (const auto& [width, height] : {std::array{31, 31}, {32, 32}, {40, 24}}) {
      SCOPED_TRACE(std::string(program.name) + " " + std::to_string(width));
      const KernelImage image = image_for(program, lopsided_template(width, height), 0.25);
      const int w = image.picture.width(), h = image.picture.height();
      if (std::string(program.name) == "unreal") {
        EXPECT_EQ(w, h);
        EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(w)));
        EXPECT_EQ(w, width == 40 ? 64 : 32);
        EXPECT_TRUE(image.center_is_brightest);
      } else {
        EXPECT_EQ(w % 2 + h % 2, 2);
      }
      EXPECT_EQ(image.center_px, (std::array{w / 2, h / 2}));
      for (const Image<float>& channel : image.picture.channels) {
        EXPECT_NEAR(sum(channel) / image.sum, 1, rounding_of(program));
        EXPECT_EQ(std::ranges::max(channel.values()), channel(w / 2, h / 2));
        for (int x = 0; x < w; ++x)
          for (const int y : {0, h - 1}) EXPECT_EQ(channel(x, y), 0);
        for (int y = 0; y < h; ++y)
          for (const int x : {0, w - 1}) EXPECT_EQ(channel(x, y), 0);
        for (const float value : channel.values()) EXPECT_LE(std::abs(value), 65504);
      }
    }
}

TEST(KernelPrograms, ConvolvingWithTheFileIsApplyWithoutARollOff) {
  // The pitch is the template's, so without a fade only the outermost ring differs: none, for
  // templates whose ring is 0.
  GlareTemplate t = lopsided_template(31, 31);
  for (Image<float>& channel : t.channels)
    for (int y = 0; y < 31; ++y)
      for (int x = 0; x < 31; ++x)
        if (std::hypot(x - 15, y - 15) >= 14.9) channel(x, y) = 0;
  const Picture scene = small_scene(), expected = with_glare(scene, t);
  for (const KernelProgram& program : kernel_programs()) {
    const KernelImage image = image_for(program, t, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Image<double> found = convolved(scene.channels[k], image.picture.channels[k],
                                            gathers(program), divisor_of(program, image, k));
      for (int y = 0; y < scene.height(); ++y)
        for (int x = 0; x < scene.width(); ++x)
          ASSERT_NEAR(found(x, y), expected.channels[k](x, y),
                      // apply_glare's transforms are within 1e-6 of the brightest pixel, 500.
                      5e-4 + 2 * rounding_of(program) * expected.channels[k](x, y))
              << program.name << " " << k << " " << x << " " << y;
    }
  }
}

TEST(KernelPrograms, TheRollOffChangesNoMoreThanItTakes) {
  const GlareTemplate t = lopsided_template(32, 32);
  Picture scene = small_scene();
  const Picture expected = with_glare(scene, t);
  for (const KernelProgram& program : kernel_programs()) {
    const KernelImage image = image_for(program, t, 0.25);
    for (std::size_t k = 0; k < 3; ++k) {
      const double taken = image.taken[k];
      EXPECT_GT(taken, 0.01);  // The streaks do reach the border.
      EXPECT_LT(taken, 0.5);
      const Image<double> found = convolved(scene.channels[k], image.picture.channels[k],
                                            gathers(program), divisor_of(program, image, k));
      for (int y = 0; y < scene.height(); ++y)
        for (int x = 0; x < scene.width(); ++x) {
          const double brightest = std::ranges::max(scene.channels[k].values());
          const double own = scene.channels[k](x, y),
                       change = found(x, y) - expected.channels[k](x, y);
          const double rounding = 1e-3 * expected.channels[k](x, y) + 5e-4;
          ASSERT_LE(change, taken * own + rounding) << program.name;
          ASSERT_GE(change, -taken * brightest - rounding) << program.name;
        }
    }
  }
}

TEST(KernelPrograms, AlphaIsWhatTheProgramMakesOfIt) {
  const GlareTemplate t = lopsided_template(31, 31);
  const KernelImage nuke = image_for(kernel_program("nuke"), t, 0.25);
  EXPECT_NEAR(sum(nuke.alpha), 1, 1e-6);
  const auto& rgb = nuke.picture.channels;
  EXPECT_NEAR(nuke.alpha(20, 11),  // BT.709's weights of luminance.
              0.2126 * rgb[0](20, 11) + 0.7152 * rgb[1](20, 11) + 0.0722 * rgb[2](20, 11), 1e-6);
  const KernelImage blender = image_for(kernel_program("blender"), t, 0.25);
  EXPECT_EQ(blender.alpha(15, 15), 1);
  EXPECT_EQ(sum(blender.alpha), 1);
  EXPECT_TRUE(image_for(kernel_program("unreal"), t, 0.25).alpha.empty());
}

TEST(KernelPrograms, OtherNamesAndSizesAreRefused) {
  EXPECT_THROW(kernel_program("gimp"), OptionError);
  const PixelKernel kernel =
      pixel_kernel(lopsided_template(9, 9), {kPitch, 1}, lin_rec709_color_space());
  KernelImageOptions options;
  for (const int size : {2, 30, 8193}) {
    options.size_px = size;
    EXPECT_THROW(kernel_image(kernel, options), OptionError) << size;
  }
  options.size = KernelImageOptions::Size::power_of_two;
  options.size_px = 31;
  EXPECT_THROW(kernel_image(kernel, options), OptionError);
}

}  // namespace
}  // namespace glare
