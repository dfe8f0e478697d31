#include "glare/convolution/shifted_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "glare/template/grid_means.h"

namespace glare {

namespace {

/// The mean of the four values `distance` pixels right, left, below and above the axis; 0 beyond.
double mean_around(const Image<float>& kernel, int distance) {
  const int column = kernel.width() / 2, row = kernel.height() / 2;
  double sum = 0;
  if (distance <= column)
    sum += double{kernel(column - distance, row)} + double{kernel(column + distance, row)};
  if (distance <= row)
    sum += double{kernel(column, row - distance)} + double{kernel(column, row + distance)};
  return sum / 4;
}

/// What rises from the axis' pixel alone: its value less that which those around lead to, a
/// parabola of even order through one and two pixels' distance. A tenth of the value is left
/// the smooth part, so that a core as wide as pixels is smooth altogether.
double sharp_core(const Image<float>& kernel) {
  const double own = double{kernel(kernel.width() / 2, kernel.height() / 2)};
  const double smooth = (4 * mean_around(kernel, 1) - mean_around(kernel, 2)) / 3;
  const double beyond = std::abs(own) - std::max(0.0, std::copysign(1.0, own) * smooth);
  const double sharp = std::max(0.0, beyond - 0.1 * std::abs(own)) / 0.9;
  return std::copysign(sharp, own);
}

double sum(const Image<float>& kernel) {
  double result = 0;
  for (const float value : kernel.values()) result += double{value};
  return result;
}

/// The sums of the values times their places right of and below the axis.
std::array<double, 2> moments(const Image<float>& kernel) {
  std::array<double, 2> result{};
  for (int y = 0; y < kernel.height(); ++y) {
    double row_sum = 0;
    for (int x = 0; x < kernel.width(); ++x) {
      const double value = double{kernel(x, y)};
      row_sum += value;
      result[0] += value * (x - kernel.width() / 2);
    }
    result[1] += row_sum * (y - kernel.height() / 2);
  }
  return result;
}

/// Adds to the four pixels around a place, -1 to 1 pixel from the axis.
void add_core(Image<float>& kernel, double core, double shift_x_px, double shift_y_px) {
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const double weight = std::max(0.0, 1 - std::abs(shift_x_px - dx)) *
                            std::max(0.0, 1 - std::abs(shift_y_px - dy));
      if (weight > 0)
        kernel(kernel.width() / 2 + dx, kernel.height() / 2 + dy) +=
            static_cast<float>(weight * core);
    }
}

}  // namespace

PixelKernel shifted(const PixelKernel& kernel, double shift_x_px, double shift_y_px, int threads) {
  PixelKernel result = kernel;
  if (shift_x_px == 0 && shift_y_px == 0) return result;
  const GridAxis across{kernel.width() + 2, 1, shift_x_px};
  const GridAxis down{kernel.height() + 2, 1, shift_y_px};
  for (Image<float>& channel : result.channels) {
    const double core = sharp_core(channel);
    channel(channel.width() / 2, channel.height() / 2) -= static_cast<float>(core);
    const double rest = sum(channel);
    const auto before = moments(channel);
    channel = grid_means(channel, across, down, threads);
    if (core == 0) continue;
    // Where the cubics fall short of the shift, the core goes so much farther.
    const auto after = moments(channel);
    const auto place = [&](std::size_t k, double shift) {
      return std::clamp(shift + (before[k] + rest * shift - after[k]) / core, -1.0, 1.0);
    };
    add_core(channel, core, place(0, shift_x_px), place(1, shift_y_px));
  }
  return result;
}

}  // namespace glare
