#include "glare/integration/ring_pixels.h"

#include <algorithm>
#include <vector>

#include "glare/base/parallel.h"
#include "glare/integration/log_spectrum.h"
#include "glare/integration/pixel_means.h"
#include "glare/integration/ray_convolution.h"

namespace glare {

namespace {

/// The share of the integral that detail beyond the convolution's reach may add.
constexpr double kNeglectedDetail = 0.01;

/// Pixels of the half plane that a band holds.
double pixels_of(const RayBand& band) {
  const double rows = band.end_px - band.begin_px;
  return rows * (2.0 * std::min(band.across_px, (band.begin_px + band.end_px) / 2) + 1);
}

/// Working memory, kept from band to band.
struct Memory {
  GrowingBuffer<float> ray_values;
  WorkspacePool<RayConvolution::Workspace> convolution;
  WorkspacePool<PixelMeans::Workspace> pixels;
};

void integrate_band(const FarField& field, const PixelGrid& grid, const SubPixels& sub,
                    const RayBand& band, const LogSpectrum& light, int threads,
                    const ProgressCallback& progress, Memory& memory, XyzImage& image) {
  constexpr double kShareOfRays = 0.6;
  RayConvolution convolution(field, band, resampled(light, band.fine_step), memory.ray_values);
  parallel_for(
      convolution.tile_count(), threads,
      [&](int tile) { convolution.compute_tile(tile, *memory.convolution.take()); },
      progress_part(progress, 0, kShareOfRays));
  const PixelMeans means(convolution.result(), band, sub, grid);
  parallel_for(
      means.tile_count(), threads,
      [&](int tile) { means.compute_tile(tile, *memory.pixels.take(), image); },
      progress_part(progress, kShareOfRays, 1));
}

}  // namespace

void integrate_ring_pixels(const FarField& field, const PixelGrid& grid, const SubPixels& sub,
                           int begin_px, const Spectrum& lamp,
                           const ColorMatchingFunctions& observer, const WavelengthRange& range,
                           int threads, const ProgressCallback& progress, XyzImage& image) {
  const double finest = finest_log_step(field, grid, sub, range);
  const LogSpectrum light = log_spectrum(lamp, observer, range, finest);
  const DetailSpectrum detail(light);
  const auto cutoff = [&](double bandwidth) { return detail.cutoff(bandwidth, kNeglectedDetail); };
  const std::vector<RayBand> bands = ray_bands(field, grid, sub, range, begin_px, cutoff);
  double all = 0, done = 0;
  for (const RayBand& band : bands) all += pixels_of(band);
  Memory memory;
  for (const RayBand& band : bands) {
    const double before = done / all;
    done += pixels_of(band);
    integrate_band(field, grid, sub, band, light, threads,
                   progress_part(progress, before, done / all), memory, image);
  }
}

}  // namespace glare
