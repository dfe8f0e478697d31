// Pictures without frequencies beyond their reach: drawn finely, filtered, thinned out. Internal.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "glare/aperture/aperture.h"
#include "glare/aperture/coverage.h"
#include "glare/base/progress.h"

namespace glare {

/// What becomes of the frequencies of a picture that is made of one with `kFineSamples` times as
/// many samples in x and in y, each the mean over its square. In cycles per pixel of the picture:
struct BandLimit {
  static constexpr int kFineSamples = 4;
  /// Up to here the far field is what it was before the averaging over squares, to `kRipple`.
  static constexpr double kPassed = 0.4;
  /// From here on, where the far field would fold onto what is passed, it is reduced to `kRipple`.
  static constexpr double kStopped = 0.6;
  static constexpr double kRipple = 1e-3;
};

/// The filter: weights of fine samples one after the other, symmetric, their sum 1. Their number is
/// even: the middle is between two fine samples, where the pixel's centre is.
std::vector<double> band_limiting_weights();

/// A row of the fine picture: the columns outside which it is 0, and the sum over its squares of
/// the mean of t(x)^2 in each. (A sample's own square is less than that on an edge.)
struct FineRow {
  Columns open;
  double mean_squares = 0;
};

/// Sets all of row `y` of the fine picture to the means of t(x), from 0 to 1.
using FineRows = std::function<FineRow(const Grid& grid, int y, std::span<float> row)>;

/// The picture of `size` x `size` samples over `width_mm`, filtered from a fine one, which is 0
/// beyond its edges. `fine_rows` gives something to draw rows with, for one thread at a time; rows
/// are drawn once or twice. The same samples for any number of threads.
Aperture band_limited(int size, double width_mm, const std::function<FineRows()>& fine_rows,
                      int threads, const ProgressCallback& progress);

}  // namespace glare
