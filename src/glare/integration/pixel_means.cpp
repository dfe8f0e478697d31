#include "glare/integration/pixel_means.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace glare {

namespace {

/// Across rays.
const InterpolationTable<12>& ray_interpolation() {
  static const InterpolationTable<12> table(7.5);
  return table;
}

constexpr int kTaps = InterpolationTable<12>::kTaps;

/// For the logarithm of the distance.
const PointInterpolation& radial_interpolation() {
  static const PointInterpolation interpolation(WindowedSinc{12, 6});
  return interpolation;
}

}  // namespace

PixelMeans::PixelMeans(const RayXyz& rays, const RayBand& band, const SubPixels& sub,
                       const PixelGrid& grid, bool odd)
    : rays_(rays), band_(band), sub_(sub), grid_(grid), odd_(odd) {
  const int height = std::clamp(kLongestTile / sub.per_pixel, 1, kLongestTile);
  const int width = std::clamp(512 / sub.per_pixel, 16, 256);
  for (int y = band.begin_px; y < band.end_px; y += height) {
    const int y_end = std::min(y + height, band.end_px);
    const int across = std::min(y_end - 1, band.across_px);
    for (int x = -across; x <= across; x += width)
      tiles_.push_back({y, y_end, x, std::min(x + width, across + 1)});
  }
}

/// Rows of a tile in memory are a little longer than the tile, so that columns don't all fall into
/// the same part of the cache.
int PixelMeans::row_length(const Tile& tile) { return tile.minor1 - tile.minor0 + kRaysPerBlock; }

void PixelMeans::compute_tile(int index, Workspace& work, XyzImage& image) const {
  const Tile& tile = tiles_[static_cast<std::size_t>(index)];
  const auto pixels = static_cast<std::size_t>(row_length(tile)) *
                      static_cast<std::size_t>(tile.major1 - tile.major0);
  for (auto& sums : work.sums) sums.assign(pixels, 0.0f);
  const int first = tile.major0 * sub_.per_pixel - sub_.reach;
  const int last = (tile.major1 - 1) * sub_.per_pixel + sub_.reach;
  for (int place = first; place <= last; ++place) add_line(tile, place, work);
  store(tile, work, image);
}

PixelMeans::RadialWeights PixelMeans::radial_weights(int place) const {
  const double log_rad = std::log(place * sub_.pitch_rad);
  const double row = (log_rad - rays_.first_log_rad) / rays_.log_step;
  const int whole = static_cast<int>(row);
  const auto taps = radial_interpolation().weights_at(row - whole);
  RadialWeights result;
  result.first_row = whole - WindowedSinc::kMostTaps / 2 + 1;
  // The rows' own scales are taken back one by one, so that what is constant stays so.
  double scale =
      std::exp(-RaySamples::kWhitening * (rays_.first_log_rad - std::log(rays_.theta_scale_rad) +
                                          result.first_row * rays_.log_step));
  const double next_scale = std::exp(-RaySamples::kWhitening * rays_.log_step);
  for (std::size_t j = 0; j < result.weights.size(); ++j, scale *= next_scale)
    result.weights[j] = static_cast<float>(taps[j] * scale);
  return result;
}

/// Interpolates between the rays at `place`, to the places `first` and on along the minor
/// coordinate.
void PixelMeans::interpolate_line(int place, int first, int count, Workspace& work) const {
  const RadialWeights radial = radial_weights(place);
  const double rays_per_place = 1 / (place * rays_.ray_step);
  const double first_ray = first * rays_per_place - rays_.first_ray;
  const double last_ray = first_ray + (count - 1) * rays_per_place;
  const int block0 = (static_cast<int>(first_ray) - kTaps / 2 + 1) / kRaysPerBlock;
  const int block1 =
      std::min((static_cast<int>(last_ray) + kTaps / 2) / kRaysPerBlock + 1, rays_.blocks);
  const int blocks = block1 - block0;
  std::array<const float*, 3> lines;
  std::array<float*, 3> values;
  for (int c = 0; c < 3; ++c) {
    work.rays[c].resize(static_cast<std::size_t>(blocks) * kRaysPerBlock);
    const float* const rows =
        rays_.block(c, block0).data() + static_cast<std::size_t>(radial.first_row) * kRaysPerBlock;
    sum_weighted_block_rows(radial.weights, rows, rays_.block_size(), blocks, work.rays[c].data());
    work.places[c].resize(static_cast<std::size_t>(count));
    lines[c] = work.rays[c].data();
    values[c] = work.places[c].data();
  }
  interpolate(lines, {first_ray - block0 * kRaysPerBlock, rays_per_place, count},
              ray_interpolation(), values);
}

/// Adds what the line at `place` is of the means over a tile's pixels.
void PixelMeans::add_line(const Tile& tile, int place, Workspace& work) const {
  const int m = sub_.per_pixel;
  const int across = std::min((place + sub_.reach) / m, band_.across_px);
  const int minor0 = std::max(tile.minor0, -across), minor1 = std::min(tile.minor1, across + 1);
  if (minor0 >= minor1) return;
  const int pixels = minor1 - minor0;
  interpolate_line(place, minor0 * m - sub_.reach, (pixels - 1) * m + 2 * sub_.reach + 1, work);

  const int width = row_length(tile);
  // Pixels p with |place - p m| <= reach.
  const int major0 = std::max(tile.major0, (place - sub_.reach + m - 1) / m);
  const int major1 = std::min(tile.major1, (place + sub_.reach) / m + 1);
  for (int c = 0; c < 3; ++c) {
    work.pixels[c].resize(static_cast<std::size_t>(pixels));
    sum_weighted_neighbours(sub_.weights, work.places[c].data(), m, pixels, work.pixels[c].data());
    for (int major = major0; major < major1; ++major)
      add_weighted(sub_.weights[static_cast<std::size_t>(place - major * m + sub_.reach)],
                   work.pixels[c].data(), pixels,
                   work.sums[c].data() + (major - tile.major0) * width + (minor0 - tile.minor0));
  }
}

/// A run of an image row, from column x0 on, and the pixels opposite to it, which run backwards.
void PixelMeans::store_run(Image<float>& image, int x0, int y,
                           std::span<const float> values) const {
  const int x1 = x0 + static_cast<int>(values.size());
  const int row = grid_.center_y() + y, opposite = grid_.center_y() - y;
  const auto first_of = [&](int x) { return static_cast<std::ptrdiff_t>(x - x0); };
  if (row >= 0 && row < grid_.height) {
    const int begin = std::max(x0, -grid_.center_x());
    const int end = std::min(x1, grid_.width - grid_.center_x());
    if (begin < end)
      std::copy(values.begin() + first_of(begin), values.begin() + first_of(end),
                image.row(row).begin() + grid_.center_x() + begin);
  }
  if (opposite >= 0 && opposite < grid_.height) {
    const int begin = std::max(x0, grid_.center_x() - grid_.width + 1);
    const int end = std::min(x1, grid_.center_x() + 1);
    if (begin >= end) return;
    const auto target = image.row(opposite).begin() + grid_.center_x() - end + 1;
    std::reverse_copy(values.begin() + first_of(begin), values.begin() + first_of(end), target);
    if (odd_) std::transform(target, target + (end - begin), target, std::negate<float>());
  }
}

void PixelMeans::store(const Tile& tile, Workspace& work, XyzImage& image) const {
  const auto width = static_cast<std::size_t>(row_length(tile));
  const auto at = [&](int major, int minor) {
    return static_cast<std::size_t>(major - tile.major0) * width +
           static_cast<std::size_t>(minor - tile.minor0);
  };
  for (int c = 0; c < 3; ++c) {
    const float* const sums = work.sums[c].data();
    if (band_.sector == Sector::y_major) {
      for (int y = tile.major0; y < tile.major1; ++y) {
        const int begin = std::max(tile.minor0, -y), end = std::min(tile.minor1, y + 1);
        if (begin < end)
          store_run(image[c], begin, y,
                    {sums + at(y, begin), static_cast<std::size_t>(end - begin)});
      }
    } else {
      const int majors = tile.major1 - tile.major0, minors = tile.minor1 - tile.minor0;
      work.turned.resize(static_cast<std::size_t>(majors) * static_cast<std::size_t>(minors));
      transpose(sums, static_cast<std::ptrdiff_t>(width), 1, majors, minors, work.turned.data(),
                static_cast<std::size_t>(majors));
      const float* row = work.turned.data();
      for (int y = tile.minor0; y < tile.minor1; ++y, row += majors) {
        const int begin = std::max(tile.major0, std::abs(y) + 1);
        if (begin < tile.major1)
          store_run(image[c], begin, y,
                    {row + (begin - tile.major0), static_cast<std::size_t>(tile.major1 - begin)});
      }
    }
  }
}

}  // namespace glare
