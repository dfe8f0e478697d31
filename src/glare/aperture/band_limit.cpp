#include "glare/aperture/band_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "glare/base/parallel.h"
#include "glare/integration/vector_loops.h"

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
  RowFilter(int size, const Weights& weights) : stride_(size + kTapsPerPhase), part_(size) {
    for (int k = 0; k < kTaps; ++k) weights_[k % kFine][k / kFine] = weights[k];
    for (auto& phase : phases_) phase.resize(static_cast<std::size_t>(stride_));
  }

  /// Sets all of `filtered`.
  void filter(std::span<const float> fine, Columns open, std::span<float> filtered) {
    const Columns part = touched(open, static_cast<int>(filtered.size()));
    const int count = part.last - part.first;
    std::fill_n(filtered.begin(), part.first, 0.0f);
    std::fill(filtered.begin() + part.last, filtered.end(), 0.0f);
    take_phases(fine, part);
    for (int r = 0; r < kFine; ++r) {
      float* const sum = r == 0 ? filtered.data() + part.first : part_.data();
      sum_weighted_rows(weights_[r], phases_[r].data() + part.first, 1, count, sum);
      if (r > 0) add_weighted(1, sum, count, filtered.data() + part.first);
    }
  }

 private:
  static constexpr int kTapsPerPhase = kTaps / kFine;

  /// The filtered row's columns that `open` reaches.
  static Columns touched(Columns open, int size) {
    return {std::max(0, (open.first - kTaps / 2) / kFine),
            std::min(size, (open.last + kTaps / 2) / kFine + 1)};
  }

  /// phases_[r][q] is the fine sample kFine q + r - kBefore.
  void take_phases(std::span<const float> fine, Columns part) {
    const int size = static_cast<int>(fine.size());
    const int last = std::min(part.last + kTapsPerPhase, stride_);
    // Inside of these all phases are samples.
    const int begin = std::clamp((kBefore + kFine - 1) / kFine, part.first, last);
    const int end = std::clamp((size + kBefore) / kFine - 1, begin, last);
    const auto take_with_care = [&](int q) {
      for (int r = 0; r < kFine; ++r) {
        const int i = kFine * q + r - kBefore;
        phases_[r][q] = i >= 0 && i < size ? fine[i] : 0.0f;
      }
    };
    for (int q = part.first; q < begin; ++q) take_with_care(q);
    const float* source = fine.data() + (kFine * begin - kBefore);
    for (int q = begin; q < end; ++q, source += kFine)
      for (int r = 0; r < kFine; ++r) phases_[r][q] = source[r];
    for (int q = end; q < last; ++q) take_with_care(q);
  }

  std::array<std::array<float, kTapsPerPhase>, kFine> weights_;
  std::array<std::vector<float>, kFine> phases_;
  int stride_;
  std::vector<float> part_;
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
        row_(fine_.size),
        filtered_(static_cast<std::size_t>(kStored) * picture.width()) {}

  /// Sets the rows from `first` to before `last`; returns the sum of the fine rows' mean squares in
  /// them.
  double make(int first, int last) {
    double squares = 0;
    int next = kFine * first - kBefore;  // The fine row that is filtered next.
    for (int row = first; row < last; ++row) {
      const int begin = kFine * row - kBefore;
      for (; next < begin + kTaps; ++next) {
        const double drawn = filter(next);
        if (next >= kFine * first && next < kFine * last) squares += drawn;
      }
      thin_out(begin, row);
    }
    return squares;
  }

 private:
  // Filtered rows are kept twice, so that any kTaps that follow one another do so in memory too.
  static constexpr int kStored = 2 * kTaps;

  float* stored(int y) { return filtered_.data() + std::size_t(y) * picture_.width(); }

  /// Draws and filters fine row `y`, which may be outside of the picture; returns its mean squares.
  double filter(int y) {
    const int place = (y + kTaps) % kTaps, width = picture_.width();
    const std::span<float> target(stored(place), width);
    FineRow drawn;
    if (y >= 0 && y < fine_.size) drawn = draw_row_(fine_, y, row_);
    const bool any = drawn.open.first < drawn.open.last;
    if (any)
      row_filter_.filter(row_, drawn.open, target);
    else
      std::ranges::fill(target, 0.0f);
    std::ranges::copy(target, stored(place + kTaps));
    return any ? drawn.mean_squares : 0;
  }

  /// Sets a row of the picture, whose first fine row is `begin`.
  void thin_out(int begin, int row) {
    const int width = picture_.width();
    sum_weighted_rows(weights_, stored((begin + kTaps) % kTaps), width, width,
                      picture_.row(row).data());
  }

  Image<float>& picture_;
  Grid fine_;
  const Weights& weights_;
  const FineRows& draw_row_;
  RowFilter row_filter_;
  std::vector<float> row_, filtered_;
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
