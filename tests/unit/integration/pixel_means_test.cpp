#include "glare/integration/pixel_means.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace glare {
namespace {

constexpr WavelengthRange kRange{380, 780};
constexpr double kExtent_mm = 4;
constexpr double kCycle_rad = 380e-6 / kExtent_mm;  ///< The finest detail there is.

using Pattern = std::function<double(double, double)>;  ///< Of the direction, in rad.

struct Result {
  PixelGrid grid;
  int begin_px;
  XyzImage image;
};

/// The means of 1, 2 and 3 times a pattern that is put on the rays of all bands.
Result means_of(int width, int height, double pixel_cycles, const Pattern& pattern) {
  FarField field;
  field.extent_x_mm = field.extent_y_mm = kExtent_mm;
  field.bin_x_per_mm = field.bin_y_per_mm = 1 / (4 * kExtent_mm);
  field.intensity_mm2 = Image<float>(64, 64);
  Result result;
  result.grid = {width, height, pixel_cycles * kCycle_rad};
  const SubPixels sub = sub_pixels(field, result.grid, kRange);
  result.begin_px = first_ring_px(field, sub, kRange, 100);
  result.image.fill(Image<float>(width, height, std::numeric_limits<float>::quiet_NaN()));
  const auto bands =
      ray_bands(field, result.grid, sub, kRange, result.begin_px, [](double) { return 1e9; });
  for (const RayBand& band : bands) {
    const LogSpectrum light{std::log(1 / 780e-6), band.fine_step, {Xyz{1, 1, 1}}};
    std::vector<float> memory(RayConvolution::value_count(band));
    const RayConvolution layout(field, band, light, memory);
    const RayXyz& rays = layout.result();
    for (int c = 0; c < 3; ++c)
      for (int block = 0; block < rays.blocks; ++block)
        for (std::size_t i = 0; i < rays.block_size(); ++i) {
          const auto row = static_cast<double>(i / kRaysPerBlock);
          const auto ray =
              rays.first_ray + block * kRaysPerBlock + static_cast<int>(i % kRaysPerBlock);
          const double major = std::exp(rays.first_log_rad + row * rays.log_step);
          const double minor = major * ray * rays.ray_step;
          const double value =
              band.sector == Sector::x_major ? pattern(major, minor) : pattern(minor, major);
          rays.block(c, block)[i] = static_cast<float>(
              (c + 1) * value * std::pow(major / rays.theta_scale_rad, RaySamples::kWhitening));
        }
    const PixelMeans means(rays, band, sub, result.grid);
    PixelMeans::Workspace work;
    for (int tile = 0; tile < means.tile_count(); ++tile)
      means.compute_tile(tile, work, result.image);
  }
  return result;
}

/// The largest difference of a ring pixel from the mean, of the first channel's scale; pixels
/// further in must be left alone. How many pixels there are in the rings is counted, too.
double worst_error(const Result& result, const Pattern& mean, int& count) {
  double worst = 0;
  const PixelGrid& grid = result.grid;
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < grid.height; ++y)
      for (int x = 0; x < grid.width; ++x) {
        const int dx = x - grid.center_x(), dy = y - grid.center_y();
        const double value = result.image[c](x, y);
        if (std::max(std::abs(dx), std::abs(dy)) < result.begin_px) {
          EXPECT_TRUE(std::isnan(value)) << dx << " " << dy;
          continue;
        }
        ++count;
        const double error =
            std::abs(value / (c + 1) - mean(dx * grid.pitch_rad, dy * grid.pitch_rad));
        if (!(error <= worst)) worst = error;  // No number, where a pixel is left out.
      }
  return worst;
}

struct Case {
  int width, height;
  double pixel_cycles;
};
constexpr Case kCases[] = {{200, 200, 0.4}, {121, 120, 0.9}, {90, 40, 3.3}, {40, 91, 3.3},
                           {1, 301, 0.5},   {301, 1, 0.5},   {60, 60, 11}};

TEST(PixelMeans, AConstantComesOutConstant) {
  const auto one = [](double, double) { return 1.0; };
  int count = 0;
  for (const Case& c : kCases)
    // Between rows the whitening is taken back exactly; the rest is single precision, of dozens of
    // products.
    EXPECT_LT(worst_error(means_of(c.width, c.height, c.pixel_cycles, one), one, count), 5e-6)
        << c.width << " x " << c.height;
  EXPECT_GT(count, 3 * 60000);  // Most of all the pixels.
}

TEST(PixelMeans, AreTheMeansOfAWave) {
  // One of half the finest detail, aslant. All interpolation together is within some 1e-3 of it.
  const double qx = 0.4 / kCycle_rad, qy = 0.3 / kCycle_rad;
  const auto wave = [&](double x, double y) {
    return 2 + std::cos(2 * std::numbers::pi * (qx * x + qy * y));
  };
  int count = 0;
  for (const Case& c : kCases) {
    const auto sinc = [&](double q) {
      const double angle = std::numbers::pi * q * c.pixel_cycles * kCycle_rad;
      return std::sin(angle) / angle;
    };
    const auto mean = [&](double x, double y) {
      return 2 + sinc(qx) * sinc(qy) * (wave(x, y) - 2);
    };
    EXPECT_LT(worst_error(means_of(c.width, c.height, c.pixel_cycles, wave), mean, count), 3e-3)
        << c.width << " x " << c.height;
  }
}

}  // namespace
}  // namespace glare
