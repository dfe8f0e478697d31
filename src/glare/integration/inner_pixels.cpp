#include "glare/integration/inner_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "glare/base/parallel.h"
#include "glare/base/units.h"
#include "glare/integration/box_interpolation.h"
#include "glare/integration/sampling_density.h"
#include "glare/integration/spectral_tile.h"
#include "glare/integration/wavenumber_quadrature.h"

namespace glare {

namespace {

/// Quadrature nodes for each cycle that the pattern's finest detail goes through over the range of
/// wavenumbers. Fewer leave traces of narrow lines; docs/validation.md has the errors that are
/// left.
constexpr double kNodesPerCycle = 3, kNodesPerCycleOfNarrowLight = 16;
constexpr double kNarrowLight_nm = 20;
constexpr int kFewestNodes = 36;

/// Detail finer than this share of a pixel is averaged away in the pixel's mean.
constexpr double kFinestDetail_px = 1;

double wavenumber_span_per_mm(const WavelengthRange& range) {
  return 1 / (range.lo_nm * kMmPerNm) - 1 / (range.hi_nm * kMmPerNm);
}

/// How many quadrature nodes the pixel of a tile farthest from the axis needs. As the wavenumber nu
/// grows, the light from two places of the aperture x apart goes through theta.x nu cycles.
int node_count(const Tile& tile, const FarField& field, double pitch_rad,
               const WavelengthRange& range, double nodes_per_cycle) {
  const double theta_x = pitch_rad * std::max(std::abs(tile.x0), std::abs(tile.x1));
  const double theta_y = pitch_rad * std::max(std::abs(tile.y0), std::abs(tile.y1));
  const double farthest_mm = range.hi_nm * kMmPerNm / (kFinestDetail_px * pitch_rad);
  const double path_mm = theta_x * std::min(field.extent_x_mm, farthest_mm) +
                         theta_y * std::min(field.extent_y_mm, farthest_mm);
  const double nodes = kFewestNodes + nodes_per_cycle * path_mm * wavenumber_span_per_mm(range);
  // Rounded up to a few sizes, so that many tiles share one quadrature.
  return static_cast<int>(std::exp2(std::ceil(std::log2(nodes) * 4) / 4));
}

/// The kernel for a field's samples.
const BoxInterpolation& interpolation_for(const FarField& field) {
  static const BoxInterpolation interpolating(kInterpolatingKernel), averaging(kAveragingKernel);
  return is_densely_sampled(field) ? interpolating : averaging;
}

/// Tiles that cover the half plane dx >= 0 as far as |dx|, |dy| < `end_px`; the other half follows
/// by symmetry.
std::vector<Tile> inner_tiles(const PixelGrid& grid, int end_px) {
  constexpr int size = 32;
  const int x_end = std::min(grid.center_x() + 1, end_px);
  const int y_end = std::min(grid.center_y() + 1, end_px);
  std::vector<Tile> tiles;
  for (int y = 1 - y_end; y < y_end; y += size)
    for (int x = 0; x < x_end; x += size)
      tiles.push_back({x, std::min(x + size, x_end), y, std::min(y + size, y_end)});
  return tiles;
}

void set_pixel(XyzImage& image, int x, int y, const std::array<float, 3>& xyz) {
  if (x < 0 || y < 0 || x >= image[0].width() || y >= image[0].height()) return;
  for (int k = 0; k < 3; ++k) image[k](x, y) = xyz[k];
}

/// Writes a tile and its mirror image through the axis. On the column dx = 0, which is its own
/// mirror, the upper half serves both. `opposite` is the sign of the mirror image.
void store(const Tile& tile, const std::array<std::vector<float>, 3>& xyz, const PixelGrid& grid,
           float opposite, XyzImage& image) {
  std::size_t i = 0;
  for (int dy = tile.y0; dy < tile.y1; ++dy)
    for (int dx = tile.x0; dx < tile.x1; ++dx, ++i) {
      if (dx == 0 && dy > 0) continue;
      const std::array<float, 3> value = {xyz[0][i], xyz[1][i], xyz[2][i]};
      set_pixel(image, grid.center_x() + dx, grid.center_y() + dy, value);
      if (dx != 0 || dy != 0)
        set_pixel(image, grid.center_x() - dx, grid.center_y() - dy,
                  {opposite * value[0], opposite * value[1], opposite * value[2]});
    }
}

}  // namespace

void integrate_inner_pixels(const FarField& field, const PixelGrid& grid, int end_px,
                            const Spectrum& lamp, const ColorMatchingFunctions& observer,
                            const WavelengthRange& range, int threads,
                            const ProgressCallback& progress, XyzImage& image) {
  const std::vector<Tile> tiles = inner_tiles(grid, end_px);
  const double nodes_per_cycle = effective_width_nm(lamp, observer, range) < kNarrowLight_nm
                                     ? kNodesPerCycleOfNarrowLight
                                     : kNodesPerCycle;
  std::map<int, WavenumberQuadrature> quadratures;
  std::vector<const WavenumberQuadrature*> quadrature_of_tile;
  for (const Tile& tile : tiles) {
    const int nodes = node_count(tile, field, grid.pitch_rad, range, nodes_per_cycle);
    auto& quadrature = quadratures[nodes];
    if (quadrature.weights.empty())
      quadrature = wavenumber_quadrature(lamp, observer, range, nodes);
    quadrature_of_tile.push_back(&quadrature);
  }
  const BoxInterpolation& interpolation = interpolation_for(field);
  const auto one_tile = [&](int i) {
    TileIntegrator integrator(field, grid.pitch_rad, interpolation);
    store(tiles[i], integrator.integrate(tiles[i], *quadrature_of_tile[i]), grid,
          field.odd ? -1.0f : 1.0f, image);
  };
  parallel_for(static_cast<int>(tiles.size()), threads, one_tile, progress);
}

}  // namespace glare
