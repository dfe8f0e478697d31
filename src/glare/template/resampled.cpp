#include "glare/template/resampled.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "glare/base/range_check.h"
#include "glare/template/grid_means.h"

namespace glare {

namespace {

/// The old pixels that a new one overlaps, and the share of its length that each has.
struct Overlaps {
  int first = 0;
  std::vector<float> shares;
};

std::vector<Overlaps> overlaps(int old_pixels, double pitch_ratio, int new_pixels) {
  std::vector<Overlaps> result(static_cast<std::size_t>(new_pixels));
  for (int i = 0; i < new_pixels; ++i) {
    // In old pixels, the first of which begins at 0.
    const double middle = (i - new_pixels / 2) * pitch_ratio + old_pixels / 2 + 0.5;
    const double begin = std::clamp(middle - 0.5 * pitch_ratio, 0.0, 1.0 * old_pixels);
    const double end = std::clamp(middle + 0.5 * pitch_ratio, 0.0, 1.0 * old_pixels);
    Overlaps& pixel = result[static_cast<std::size_t>(i)];
    pixel.first = static_cast<int>(begin);
    for (int k = pixel.first; k < end; ++k)
      pixel.shares.push_back(
          static_cast<float>((std::min(end, k + 1.0) - std::max(begin, 1.0 * k)) / pitch_ratio));
  }
  return result;
}

}  // namespace

Image<float> area_means(const Image<float>& picture, double pitch_ratio, int width, int height) {
  const auto columns = overlaps(picture.width(), pitch_ratio, width);
  const auto rows = overlaps(picture.height(), pitch_ratio, height);
  Image<float> result(width, height);
  std::vector<float> row_sum(static_cast<std::size_t>(picture.width()));
  for (int y = 0; y < height; ++y) {
    const Overlaps& row = rows[static_cast<std::size_t>(y)];
    std::fill(row_sum.begin(), row_sum.end(), 0.f);
    for (std::size_t k = 0; k < row.shares.size(); ++k) {
      const auto values = picture.row(row.first + static_cast<int>(k));
      for (std::size_t x = 0; x < row_sum.size(); ++x) row_sum[x] += row.shares[k] * values[x];
    }
    for (int x = 0; x < width; ++x) {
      const Overlaps& column = columns[static_cast<std::size_t>(x)];
      const float* values = row_sum.data() + column.first;
      float sum = 0;
      for (const float share : column.shares) sum += share * *values++;
      result(x, y) = sum;
    }
  }
  return result;
}

int covering_size(int old_pixels, double pitch_ratio, double shift_px) {
  // The longer side from the centre of the axis' pixel, in new pixels.
  const double reach = (old_pixels / 2 + 0.5) / pitch_ratio + std::abs(shift_px);
  return 2 * static_cast<int>(std::ceil(reach - 0.5 - 1e-9)) + 1;
}

GlareTemplate resampled(const GlareTemplate& t, double pitch_rad, int width, int height) {
  require_in_range("a template's pitch in radians", pitch_rad, std::numeric_limits<double>::min(),
                   1);
  require_in_range("a template's width in pixels", width, 1, 1 << 16);
  require_in_range("a template's height in pixels", height, 1, 1 << 16);
  GlareTemplate result = t;
  double old_sum = 0, new_sum = 0;
  const double ratio = pitch_rad / t.pixel_pitch_rad;
  const Vector3& weights = t.color_space.xyz_from_rgb()[1];
  for (std::size_t k = 0; k < 3; ++k) {
    for (const float value : t.channels[k].values()) old_sum += weights[k] * value;
    result.channels[k] = grid_means(t.channels[k], {width, ratio}, {height, ratio});
    for (const float value : result.channels[k].values()) new_sum += weights[k] * value;
  }
  result.pixel_pitch_rad = pitch_rad;
  if (old_sum > 0) result.captured_energy = t.captured_energy * new_sum * ratio * ratio / old_sum;
  result.normalization = Normalization::absolute;
  rescale(result, 1);
  return result;
}

}  // namespace glare
