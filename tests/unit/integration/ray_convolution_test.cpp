#include "glare/integration/ray_convolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "glare/spectrum/lamps.h"

namespace glare {
namespace {

constexpr double kBin = 1.0 / 16;  ///< Of an extent of 4 mm, padded four times.
constexpr int kLast = 700;         ///< The last sample held, both ways.
constexpr double kWhitening = RaySamples::kWhitening;

using Intensity = std::function<double(double)>;  ///< Of the major frequency, in 1 / mm.

double constant(double) { return 3; }
double power_law(double f) { return 1000 / (f * f); }
double wave(double f) { return 2 + std::cos(9 * std::log(f)); }

FarField field_of(Sector sector, const Intensity& intensity) {
  FarField field;
  field.first_kx = -40;
  field.first_ky = -kLast;
  field.bin_x_per_mm = field.bin_y_per_mm = kBin;
  field.extent_x_mm = field.extent_y_mm = 4;
  field.intensity_mm2 = Image<float>(2 * kLast + 1, kLast + 41);
  for (int kx = field.first_kx; kx <= kLast; ++kx)
    for (int ky = -kLast; ky <= kLast; ++ky) {
      const int major = std::max(1, std::abs(sector == Sector::x_major ? kx : ky));
      field.intensity_mm2(ky + kLast, kx + 40) = static_cast<float>(intensity(major * kBin));
    }
  return field;
}

/// An octave whose frequencies are from 100 to 700 samples; its margins, too.
RayBand band_of(Sector sector, int decimation) {
  RayBand band{};
  band.sector = sector;
  band.first_rad = 100 * kBin * 780e-6 * 1.15;
  band.last_rad = 600 * kBin * 380e-6;
  band.ray_step = 0.03;
  band.rays_each_side = 37;
  band.near_axis = true;
  band.fine_step = 0.0024 / decimation;
  band.decimation = decimation;
  return band;
}

/// The largest difference from the direct sum over the light's weights, as a share of the largest
/// of all sums: as they are convolved together, single precision rounds all alike.
double worst_error(Sector sector, int decimation, const char* lamp, const Intensity& intensity) {
  const auto& observer = color_matching_functions("cie1931-2deg");
  const FarField field = field_of(sector, intensity);
  const RayBand band = band_of(sector, decimation);
  const LogSpectrum light = log_spectrum(*find_lamp(lamp), observer, {380, 780}, band.fine_step);
  std::vector<float> memory(RayConvolution::value_count(band));
  const RayConvolution convolution(field, band, light, memory);
  RayConvolution::Workspace work;
  for (int tile = 0; tile < convolution.tile_count(); ++tile) convolution.compute_tile(tile, work);

  const RayXyz& rays = convolution.result();
  EXPECT_EQ(rays.first_ray, -37);
  EXPECT_EQ(rays.blocks, 5);  // Of 16 rays, 75 in all.
  double worst = 0, largest = 0;
  for (int row = RayConvolution::kMarginRows; row < rays.rows - RayConvolution::kMarginRows;
       ++row) {
    const double log_rad = rays.first_log_rad + row * rays.log_step;
    Xyz sum{};
    for (std::size_t i = 0; i < light.weights.size(); ++i) {
      const double log = log_rad + light.first_log_per_mm + static_cast<double>(i) * light.log_step;
      for (int c = 0; c < 3; ++c) sum[c] += light.weights[i][c] * intensity(std::exp(log));
    }
    const double whitening = std::exp(kWhitening * (log_rad - std::log(rays.theta_scale_rad)));
    for (int c = 0; c < 3; ++c) {
      largest = std::max(largest, std::abs(sum[c] * whitening));
      for (int ray = 0; ray < 75; ++ray) {
        const double value = rays.block(
            c,
            ray /
                kRaysPerBlock)[static_cast<std::size_t>(row * kRaysPerBlock + ray % kRaysPerBlock)];
        if (!(std::abs(value - sum[c] * whitening) <= worst))
          worst = std::abs(value - sum[c] * whitening);
      }
    }
  }
  return worst / largest;
}

// A transform of a thousand rows there and back rounds some twenty times: 1e-6.

TEST(RayConvolution, OfAConstantIsTheLightsSum) {
  for (const Sector sector : {Sector::x_major, Sector::y_major})
    for (const char* lamp : {"D65", "FL11"})
      EXPECT_LT(worst_error(sector, 1, lamp, constant), 5e-6) << lamp;
}

TEST(RayConvolution, IsTheDirectSumOverTheLight) {
  // The far field is interpolated in samples, of which the wave has some 70 and more a period.
  for (const Sector sector : {Sector::x_major, Sector::y_major})
    for (const char* lamp : {"D65", "FL11"})
      for (const Intensity& intensity : {Intensity(power_law), Intensity(wave)})
        EXPECT_LT(worst_error(sector, 1, lamp, intensity), 5e-6) << lamp;
}

TEST(RayConvolution, IsTheSameInFewerSteps) {
  // What the averages take of smooth detail is put back.
  for (const Sector sector : {Sector::x_major, Sector::y_major})
    for (const int decimation : {2, 5})
      for (const Intensity& intensity :
           {Intensity(constant), Intensity(power_law), Intensity(wave)})
        EXPECT_LT(worst_error(sector, decimation, "D65", intensity), 5e-6) << decimation;
}

}  // namespace
}  // namespace glare
