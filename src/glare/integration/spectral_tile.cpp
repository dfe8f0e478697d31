#include "glare/integration/spectral_tile.h"

#include <algorithm>
#include <cassert>

#include "glare/integration/vector_loops.h"

namespace glare {

namespace {

/// The edges, in samples of the far field, of the pixels from `begin` to `end` at a wavenumber.
void set_edges(int begin, int end, double samples_per_pixel, std::vector<double>& edges) {
  edges.resize(static_cast<std::size_t>(end - begin + 1));
  for (int i = begin; i <= end; ++i)
    edges[static_cast<std::size_t>(i - begin)] = (i - 0.5) * samples_per_pixel;
}

bool all_zero(const std::array<float, 3>& weights) {
  return weights[0] == 0 && weights[1] == 0 && weights[2] == 0;
}

}  // namespace

const std::array<std::vector<float>, 3>& TileIntegrator::integrate(
    const Tile& tile, const WavenumberQuadrature& quadrature) {
  assert(tile.width() <= kTileSize && tile.height() <= kTileSize);
  const auto pixels = static_cast<std::size_t>(tile.width() * tile.height());
  for (auto& channel : xyz_) channel.assign(pixels, 0.0f);
  for (std::size_t k = 0; k < quadrature.weights.size(); ++k)
    if (!all_zero(quadrature.weights[k]))
      add_wavenumber(tile, quadrature.wavenumbers_per_mm[k], quadrature.weights[k]);
  return xyz_;
}

void TileIntegrator::add_wavenumber(const Tile& tile, double wavenumber_per_mm,
                                    const std::array<float, 3>& weights) {
  const double pixel_per_mm = pitch_rad_ * wavenumber_per_mm;
  set_edges(tile.x0, tile.x1, pixel_per_mm / field_.bin_x_per_mm, edges_);
  interpolation_.weights_between(edges_, column_boxes_);
  set_edges(tile.y0, tile.y1, pixel_per_mm / field_.bin_y_per_mm, edges_);
  interpolation_.weights_between(edges_, row_boxes_);
  first_ky_ = row_boxes_.front().first;
  ky_count_ =
      row_boxes_.back().first + static_cast<int>(row_boxes_.back().weights.size()) - first_ky_;
  reduce_columns();
  transpose_reduced();
  reduce_rows_and_add(tile, weights);
}

void TileIntegrator::reduce_columns() {
  const auto count = static_cast<std::size_t>(ky_count_);
  const auto stride = static_cast<std::size_t>(field_.intensity_mm2.width());
  reduced_.resize(column_boxes_.size() * count);
  assert(first_ky_ >= field_.first_ky &&
         first_ky_ + ky_count_ <= field_.first_ky + field_.intensity_mm2.width());
  for (std::size_t i = 0; i < column_boxes_.size(); ++i) {
    const BoxWeights& box = column_boxes_[i];
    assert(box.first >= field_.first_kx && box.first + static_cast<int>(box.weights.size()) <=
                                               field_.first_kx + field_.intensity_mm2.height());
    const float* const rows = field_.intensity_mm2.row(box.first - field_.first_kx).data() +
                              (first_ky_ - field_.first_ky);
    sum_weighted_rows(box.weights, rows, stride, ky_count_, reduced_.data() + i * count);
  }
}

void TileIntegrator::transpose_reduced() {
  const std::size_t columns = column_boxes_.size();
  transposed_.resize(reduced_.size());
  transpose(reduced_.data(), ky_count_, 1, static_cast<int>(columns), ky_count_, transposed_.data(),
            columns);
}

void TileIntegrator::reduce_rows_and_add(const Tile& tile, const std::array<float, 3>& weights) {
  const auto columns = static_cast<std::size_t>(tile.width());
  std::array<float, kTileSize> line;
  for (std::size_t j = 0; j < row_boxes_.size(); ++j) {
    const BoxWeights& box = row_boxes_[j];
    const float* const rows =
        transposed_.data() + static_cast<std::size_t>(box.first - first_ky_) * columns;
    sum_weighted_rows(box.weights, rows, columns, tile.width(), line.data());
    for (int k = 0; k < 3; ++k)
      add_weighted(weights[k], line.data(), tile.width(), xyz_[k].data() + j * columns);
  }
}

}  // namespace glare
