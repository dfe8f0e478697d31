#include "glare/integration/spectral_integral.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/base/units.h"
#include "glare/integration/box_interpolation.h"
#include "glare/integration/spectral_tile.h"
#include "glare/integration/wavenumber_quadrature.h"

namespace glare {

namespace {

/// Quadrature nodes for each cycle that the pattern's finest detail goes through over the range of
/// wavenumbers. Fewer leave traces of narrow lines; docs/validation.md has the errors that are
/// left. Light of all but one wavelength has speckles with dark nulls, which no other light fills,
/// and needs more.
constexpr double kNodesPerCycle = 3, kNodesPerCycleOfNarrowLight = 10;
constexpr double kNarrowLight_nm = 20;
constexpr int kFewestNodes = 48;

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

/// Padding by which samples are at twice the critical rate, for `kInterpolatingKernel`.
constexpr double kPaddingToInterpolate = 4;

/// The zero-padding for a pixel of that many cycles of the intensity's finest detail. Narrow pixels
/// are interpolated and need the denser samples; wide ones average over many samples.
double padding_for(double pixel_cycles) {
  if (pixel_cycles < 1) return kPaddingToInterpolate;
  return pixel_cycles < 3 ? 3 : 2.5;
}

/// The kernel for a field's samples.
const WindowedSinc& kernel_for(const FarField& field) {
  const double padding =
      1 / std::max(field.bin_x_per_mm * field.extent_x_mm, field.bin_y_per_mm * field.extent_y_mm);
  constexpr double kRounding = 1e-9;
  return padding >= kPaddingToInterpolate - kRounding ? kInterpolatingKernel : kAveragingKernel;
}

/// Tiles that cover the half plane dx >= 0; the other half follows by symmetry.
std::vector<Tile> half_plane_tiles(const PixelGrid& grid) {
  constexpr int size = TileIntegrator::kTileSize;
  const int x_end = grid.center_x() + 1;
  const int y_begin = -grid.center_y(), y_end = grid.center_y() + 1;
  std::vector<Tile> tiles;
  for (int y = y_begin; y < y_end; y += size)
    for (int x = 0; x < x_end; x += size)
      tiles.push_back({x, std::min(x + size, x_end), y, std::min(y + size, y_end)});
  return tiles;
}

/// Throws unless the field holds all samples that the outermost pixels take at the shortest
/// wavelength.
void require_wide_enough(const FarField& field, const PixelGrid& grid,
                         const WavelengthRange& range) {
  const FarFieldRequest needed = far_field_request(field.extent_x_mm, grid, range);
  const auto samples = [](double frequency_per_mm, double bin_per_mm) {
    return frequency_per_mm / bin_per_mm + WindowedSinc::kMostTaps / 2 + 1;
  };
  const double last_kx = field.first_kx + field.intensity_mm2.height() - 1;
  const double overlap = samples(needed.overlap_frequency_x_per_mm, field.bin_x_per_mm);
  if (samples(needed.max_frequency_x_per_mm, field.bin_x_per_mm) > last_kx ||
      samples(needed.max_frequency_y_per_mm, field.bin_y_per_mm) > -field.first_ky ||
      std::min(overlap, last_kx) > -field.first_kx)
    throw OptionError(
        "the far field was made for a narrower field of view, other pixels or longer wavelengths");
}

void set_pixel(XyzImage& image, int x, int y, const std::array<float, 3>& xyz) {
  if (x < 0 || y < 0 || x >= image[0].width() || y >= image[0].height()) return;
  for (int k = 0; k < 3; ++k) image[k](x, y) = xyz[k];
}

/// Writes a tile and its mirror image through the axis. On the column dx = 0, which is its own
/// mirror, the upper half serves both.
void store(const Tile& tile, const std::array<std::vector<float>, 3>& xyz, const PixelGrid& grid,
           XyzImage& image) {
  std::size_t i = 0;
  for (int dy = tile.y0; dy < tile.y1; ++dy)
    for (int dx = tile.x0; dx < tile.x1; ++dx, ++i) {
      if (dx == 0 && dy > 0) continue;
      const std::array<float, 3> value = {xyz[0][i], xyz[1][i], xyz[2][i]};
      set_pixel(image, grid.center_x() + dx, grid.center_y() + dy, value);
      set_pixel(image, grid.center_x() - dx, grid.center_y() - dy, value);
    }
}

}  // namespace

XyzImage spectral_integral(const FarField& field, const PixelGrid& grid, const Spectrum& lamp,
                           const ColorMatchingFunctions& observer, const WavelengthRange& range,
                           int threads, const ProgressCallback& progress) {
  xyz_from_spectrum(lamp, observer, range);  // Throws for a lamp without light.
  require_wide_enough(field, grid, range);
  const std::vector<Tile> tiles = half_plane_tiles(grid);
  const bool narrow = effective_width_nm(lamp, observer, range) < kNarrowLight_nm;
  const double nodes_per_cycle = narrow ? kNodesPerCycleOfNarrowLight : kNodesPerCycle;
  std::map<int, WavenumberQuadrature> quadratures;
  std::vector<const WavenumberQuadrature*> quadrature_of_tile;
  for (const Tile& tile : tiles) {
    const int nodes = node_count(tile, field, grid.pitch_rad, range, nodes_per_cycle);
    auto& quadrature = quadratures[nodes];
    if (quadrature.weights.empty())
      quadrature = wavenumber_quadrature(lamp, observer, range, nodes);
    quadrature_of_tile.push_back(&quadrature);
  }

  const BoxInterpolation interpolation(kernel_for(field));
  XyzImage image;
  for (auto& channel : image) channel = Image<float>(grid.width, grid.height);
  const auto one_tile = [&](int i) {
    TileIntegrator integrator(field, grid.pitch_rad, interpolation);
    store(tiles[i], integrator.integrate(tiles[i], *quadrature_of_tile[i]), grid, image);
  };
  parallel_for(static_cast<int>(tiles.size()), threads, one_tile, progress);
  return image;
}

FarFieldRequest far_field_request(double open_side_mm, const PixelGrid& grid,
                                  const WavelengthRange& range) {
  FarFieldRequest request;
  const double per_mm = grid.pitch_rad / (range.lo_nm * kMmPerNm);
  request.max_frequency_x_per_mm = (grid.center_x() + 0.5) * per_mm;
  request.max_frequency_y_per_mm = (grid.center_y() + 0.5) * per_mm;
  request.overlap_frequency_x_per_mm = 0.5 * per_mm;
  request.padding = padding_for(grid.pitch_rad / (range.hi_nm * kMmPerNm) * open_side_mm);
  return request;
}

}  // namespace glare
