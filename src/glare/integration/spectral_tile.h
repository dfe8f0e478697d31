// One tile of the spectral integral. Internal.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glare/integration/box_interpolation.h"
#include "glare/integration/spectral_integral.h"
#include "glare/integration/wavenumber_quadrature.h"

namespace glare {

/// A rectangle of pixels, counted from the axis: columns x0 <= dx < x1 and rows y0 <= dy < y1.
struct Tile {
  int x0, x1, y0, y1;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
};

/// Integrates tiles of at most `kTileSize` pixels a side. One object for each
/// tile, with working memory of its own.
class TileIntegrator {
 public:
  static constexpr int kTileSize = 64;

  TileIntegrator(const FarField& field, double pitch_rad, const BoxInterpolation& interpolation)
      : field_(field), pitch_rad_(pitch_rad), interpolation_(interpolation) {}

  /// XYZ of the tile's pixels, row by row, `tile.width()` a row; valid until the next call.
  const std::array<std::vector<float>, 3>& integrate(const Tile& tile,
                                                     const WavenumberQuadrature& quadrature);

 private:
  void add_wavenumber(const Tile& tile, double wavenumber_per_mm,
                      const std::array<float, 3>& weights);
  void reduce_columns();
  void transpose_reduced();
  void reduce_rows_and_add(const Tile& tile, const std::array<float, 3>& weights);

  const FarField& field_;
  double pitch_rad_;
  const BoxInterpolation& interpolation_;

  std::vector<double> edges_;
  std::vector<BoxWeights> column_boxes_, row_boxes_;
  int first_ky_ = 0, ky_count_ = 0;  ///< The frequencies that the tile's rows reach.
  std::vector<float> reduced_;       ///< Tile column by ky.
  std::vector<float> transposed_;    ///< ky by tile column.
  std::array<std::vector<float>, 3> xyz_;
};

}  // namespace glare
