#include "glare/integration/ring_pixels.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "glare/base/parallel.h"
#include "glare/integration/log_spectrum.h"
#include "glare/integration/pixel_means.h"
#include "glare/integration/ray_convolution.h"

namespace glare {

namespace {

/// The share of the integral that detail beyond the convolution's reach may add.
constexpr double kNeglectedDetail = 0.01;

/// A band while it is worked on.
struct WorkingBand {
  explicit WorkingBand(const RayBand& ray_band) : band(ray_band) {}

  RayBand band;
  std::span<float> memory;
  std::unique_ptr<RayConvolution> convolution;
  std::unique_ptr<PixelMeans> means;
};
using WorkingBands = std::vector<std::unique_ptr<WorkingBand>>;

/// Calls `task(band, tile)` for all tiles of all bands, in one go: small bands have few.
void for_all_tiles(WorkingBands& bands, int threads, const ProgressCallback& progress,
                   const std::function<int(const WorkingBand&)>& tile_count,
                   const std::function<void(WorkingBand&, int)>& task) {
  std::vector<int> end_of_band;
  for (const auto& band : bands)
    end_of_band.push_back((end_of_band.empty() ? 0 : end_of_band.back()) + tile_count(*band));
  const auto one_tile = [&](int i) {
    const auto end = std::upper_bound(end_of_band.begin(), end_of_band.end(), i);
    WorkingBand& band = *bands[static_cast<std::size_t>(end - end_of_band.begin())];
    task(band, i - (*end - tile_count(band)));
  };
  parallel_for(end_of_band.back(), threads, one_tile, progress);
}

/// The bands from `begin` on that are worked on together: one, or more while they are small.
std::size_t end_of_batch(const std::vector<RayBand>& bands, std::size_t begin) {
  std::size_t values = RayConvolution::value_count(bands[begin]);
  std::size_t end = begin + 1;
  while (end < bands.size() && values + RayConvolution::value_count(bands[end]) <=
                                   static_cast<std::size_t>(kMostRayValues))
    values += RayConvolution::value_count(bands[end++]);
  return end;
}

/// Working memory, kept from batch to batch.
struct Memory {
  GrowingBuffer<float> ray_values;
  WorkspacePool<RayConvolution::Workspace> convolution;
  WorkspacePool<PixelMeans::Workspace> pixels;
};

void integrate_bands(const FarField& field, const PixelGrid& grid, const SubPixels& sub,
                     WorkingBands& bands, const LogSpectrum& light, int threads,
                     const ProgressCallback& progress, Memory& memory, XyzImage& image) {
  constexpr double kShareOfRays = 0.6;
  std::size_t count = 0;
  for (const auto& working : bands) count += RayConvolution::value_count(working->band);
  std::span<float> rest = memory.ray_values.values(count);
  for (const auto& working : bands) {
    const std::size_t part = RayConvolution::value_count(working->band);
    working->memory = rest.first(part);
    rest = rest.subspan(part);
  }
  const auto prepare = [&](int i) {
    WorkingBand& working = *bands[static_cast<std::size_t>(i)];
    const RayBand& band = working.band;
    working.convolution = std::make_unique<RayConvolution>(
        field, band, resampled(light, band.fine_step), working.memory);
    working.means =
        std::make_unique<PixelMeans>(working.convolution->result(), band, sub, grid, field.odd);
  };
  parallel_for(static_cast<int>(bands.size()), threads, prepare);
  for_all_tiles(
      bands, threads, progress_part(progress, 0, kShareOfRays),
      [](const WorkingBand& band) { return band.convolution->tile_count(); },
      [&](WorkingBand& band, int tile) {
        band.convolution->compute_tile(tile, *memory.convolution.take());
      });
  for_all_tiles(
      bands, threads, progress_part(progress, kShareOfRays, 1),
      [](const WorkingBand& band) { return band.means->tile_count(); },
      [&](WorkingBand& band, int tile) {
        band.means->compute_tile(tile, *memory.pixels.take(), image);
      });
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
  for (const RayBand& band : bands) all += static_cast<double>(RayConvolution::value_count(band));
  Memory memory;
  for (std::size_t begin = 0; begin < bands.size();) {
    WorkingBands batch;
    const double before = done / all;
    for (const std::size_t end = end_of_batch(bands, begin); begin < end; ++begin) {
      batch.push_back(std::make_unique<WorkingBand>(bands[begin]));
      done += static_cast<double>(RayConvolution::value_count(bands[begin]));
    }
    integrate_bands(field, grid, sub, batch, light, threads,
                    progress_part(progress, before, done / all), memory, image);
  }
}

}  // namespace glare
