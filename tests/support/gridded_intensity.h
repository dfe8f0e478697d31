// The intensity of an aperture's far field at any frequency, by gridding. For `exact_pixels`.
#pragma once

#include <vector>

#include "glare/aperture/aperture.h"

namespace glare::exact {

/// The Kaiser-Bessel kernel phi(u), `kTaps` samples wide, 1 at its middle.
class GriddingKernel {
 public:
  static constexpr int kTaps = 14;

  GriddingKernel();

  /// The Fourier transform of phi, at a frequency in cycles per sample, |xi| <= 1/4.
  static double transform(double xi);

  /// The mean of phi(u - k) over u from `left` to `right`, for k = first, first + 1, ...; k beyond
  /// them all have a mean of 0. Returns first.
  int means(double left, double right, std::vector<double>& weights) const;

 private:
  void add_running(double edge, int first, double factor, std::vector<double>& weights) const;

  // Integral of phi from its left end to u, and phi(u), at u = i / kSteps + j - kTaps / 2, as
  // [i][j]; between two i, the cubic with these values and slopes.
  static constexpr int kSteps = 1024;
  std::vector<double> integral_, slope_;
  double whole_ = 0;
};

/// I(f) of the samples of an aperture, in mm^2 as `FarField` has it, for every frequency: it
/// repeats after 1 / pixel.
class GriddedIntensity {
 public:
  /// Pixels up to `widest_pixel_per_mm` wide (cycles per mm) can be asked for.
  GriddedIntensity(const Aperture& aperture, double widest_pixel_per_mm, int threads);

  /// The rectangle of frequencies x0 to x1, y0 to y1, in cycles per mm.
  struct Rectangle {
    double x0, x1, y0, y1;
  };
  /// Working memory of one thread.
  struct Weights {
    std::vector<double> x, y;
  };
  /// The mean of I over a rectangle.
  double mean(const Rectangle& at, Weights& weights) const;

 private:
  GriddingKernel kernel_;
  int columns_ = 0, rows_ = 0;  ///< Frequencies, after which the intensity repeats.
  int stride_ = 0;              ///< `columns_` and so many of the first again.
  double samples_per_mm_x_ = 0, samples_per_mm_y_ = 0;
  std::vector<double> coefficients_;
};

}  // namespace glare::exact
