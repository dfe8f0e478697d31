#include "glare/aperture/band_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "glare/base/parallel.h"

namespace glare {

namespace {

constexpr int kFine = BandLimit::kFineSamples;
constexpr int kTaps = 80;  ///< A multiple of `kFine`; by Kaiser's rule for the ripple.
/// Fine samples before a pixel's first one that its filter takes.
constexpr int kBefore = (kTaps - kFine) / 2;
constexpr int kRowsPerTask = 128;

using Weights = std::array<float, kTaps>;

/// The modified Bessel function of the first kind, order 0.
double bessel_i0(double x) {
  double term = 1, sum = 1;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= (x / 2 / k) * (x / 2 / k);
    sum += term;
  }
  return sum;
}

/// Kaiser's window at `x`, -1 to 1.
double kaiser(double x) {
  constexpr double attenuation_db = 63;
  constexpr double beta = 0.1102 * (attenuation_db - 8.7);
  return bessel_i0(beta * std::sqrt(std::max(0.0, 1 - x * x))) / bessel_i0(beta);
}

/// The integral over |f| <= `end` of cos(2 pi f t) / sinc(f): the response to an impulse of what
/// passes these frequencies, in cycles per fine sample, and undoes the averaging over a sample.
double ideal_response(double t, double end) {
  constexpr int steps = 256;  // Some 20 for each of the fastest wave's periods.
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = std::numbers::pi * end * (i + 0.5) / steps;
    sum += std::cos(2 * x * t) * x / std::sin(x);
  }
  return 2 * end / steps * sum;
}

Weights weights() {
  const std::vector<double> exact = band_limiting_weights();
  Weights result;
  std::ranges::transform(exact, result.begin(), [](double w) { return static_cast<float>(w); });
  return result;
}

/// Filters one fine row in x and thins it out.
class RowFilter {
 public:
  RowFilter(int size, const Weights& weights) : weights_(weights), filtered_(size) {
    for (auto& phase : phases_) phase.resize(size + kTaps / kFine + kBlock);
  }

  /// Returns the columns outside which the filtered row is 0; it is valid within them.
  Columns filter(std::span<const float> fine, Columns open) {
    const int size = static_cast<int>(filtered_.size());
    const Columns part{std::max(0, (open.first - kTaps / 2) / kFine),
                       std::min(size, (open.last + kTaps / 2) / kFine + 1)};
    take_phases(fine, part);
    for (int x = part.first; x < part.last; x += kBlock) filter_block(x, part.last);
    return part;
  }
  const float* filtered() const { return filtered_.data(); }

 private:
  static constexpr int kBlock = 16;

  /// phases_[r][q] is the fine sample kFine q + r - kBefore.
  void take_phases(std::span<const float> fine, Columns part) {
    const int last =
        std::min(part.last + kTaps / kFine + kBlock, static_cast<int>(phases_[0].size()));
    for (int r = 0; r < kFine; ++r)
      for (int q = part.first; q < last; ++q) {
        const int i = kFine * q + r - kBefore;
        phases_[r][q] = i >= 0 && i < std::ssize(fine) ? fine[i] : 0.0f;
      }
  }

  void filter_block(int x, int last) {
    std::array<float, kBlock> sum{};
    for (int k = 0; k < kTaps; ++k) {
      const float* const source = phases_[k % kFine].data() + x + k / kFine;
      for (int i = 0; i < kBlock; ++i) sum[i] += weights_[k] * source[i];
    }
    std::copy_n(sum.begin(), std::min(kBlock, last - x), filtered_.begin() + x);
  }

  const Weights& weights_;
  std::array<std::vector<float>, kFine> phases_;
  std::vector<float> filtered_;
};

/// Makes the rows of one task.
class Band {
 public:
  Band(Image<float>& picture, double width_mm, const Weights& weights, const FineRows& draw_row)
      : picture_(picture),
        fine_{kFine * picture.width(), width_mm / (kFine * picture.width())},
        weights_(weights),
        draw_row_(draw_row),
        row_filter_(picture.width(), weights),
        row_(fine_.size) {}

  /// Sets the rows from `first` to before `last`; returns the sum of the fine rows' mean squares in
  /// them.
  double make(int first, int last) {
    const int begin = std::max(0, kFine * first - kBefore);
    const int end = std::min(fine_.size, kFine * (last - 1) - kBefore + kTaps);
    double squares = 0;
    for (int y = begin; y < end; ++y) {
      const FineRow drawn = draw_row_(fine_, y, row_);
      if (drawn.open.first >= drawn.open.last) continue;
      if (y >= kFine * first && y < kFine * last) squares += drawn.mean_squares;
      add(y, row_filter_.filter(row_, drawn.open), first, last);
    }
    return squares;
  }

 private:
  /// Adds fine row `y` to the rows from `first` to before `last` whose filters take it.
  void add(int y, Columns part, int first, int last) {
    const int newest = std::min(last - 1, (y + kBefore) / kFine);
    for (int row = newest; row >= first; --row) {
      const int k = y + kBefore - kFine * row;
      if (k >= kTaps) break;
      const float weight = weights_[k];
      const float* const source = row_filter_.filtered();
      float* const target = picture_.row(row).data();
      for (int x = part.first; x < part.last; ++x) target[x] += weight * source[x];
    }
  }

  Image<float>& picture_;
  Grid fine_;
  const Weights& weights_;
  const FineRows& draw_row_;
  RowFilter row_filter_;
  std::vector<float> row_;
};

}  // namespace

std::vector<double> band_limiting_weights() {
  constexpr double end = 0.5 * (BandLimit::kPassed + BandLimit::kStopped) / kFine;
  std::vector<double> weights;
  double sum = 0;
  for (int k = 0; k < kTaps; ++k) {
    const double t = k - 0.5 * (kTaps - 1);
    weights.push_back(ideal_response(t, end) * kaiser(t / (0.5 * kTaps)));
    sum += weights.back();
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

Aperture band_limited(int size, double width_mm, const std::function<FineRows()>& fine_rows,
                      int threads, const ProgressCallback& progress) {
  Aperture aperture{Image<float>(size, size), width_mm};
  const Weights filter = weights();
  const int tasks = (size + kRowsPerTask - 1) / kRowsPerTask;
  std::vector<double> squares(tasks);
  const auto make = [&](int task) {
    const FineRows draw_row = fine_rows();
    Band band(aperture.transmittance, width_mm, filter, draw_row);
    squares[task] = band.make(task * kRowsPerTask, std::min(size, (task + 1) * kRowsPerTask));
  };
  parallel_for(tasks, threads, make, progress);

  const double fine_pixel_mm = width_mm / (kFine * static_cast<double>(size));
  double sum = 0;
  for (const double part : squares) sum += part;
  aperture.unlimited_energy_area_mm2 = sum * fine_pixel_mm * fine_pixel_mm;
  return aperture;
}

}  // namespace glare
