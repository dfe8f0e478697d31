// Interpolation between the samples of a band-limited function. Internal.
#pragma once

#include <array>

namespace glare {

/// A sinc under Kaiser's window.
struct WindowedSinc {
  int taps;            ///< Samples that it takes in; even, at most `kMostTaps`.
  double kaiser_beta;  ///< The window's shape: more ripples less and passes less.

  static constexpr int kMostTaps = 12;
  /// A value for each tap; those beyond the number of taps are 0.
  using PerTap = std::array<double, kMostTaps>;

  friend bool operator==(const WindowedSinc&, const WindowedSinc&) = default;
};

/// For samples at twice the critical rate or more: errs by at most 4e-5 of a cosine up to five
/// sixths of the finest detail there is, and by 8e-4 at that, of which a real pattern has next to
/// nothing (box_interpolation_test).
inline constexpr WindowedSinc kInterpolatingKernel{12, 10.5};

/// For samples at 1.25 times the critical rate or more and intervals of several samples, which
/// average: errs only in the detail that the mean takes away.
inline constexpr WindowedSinc kAveragingKernel{12, 8};

/// The window times sinc(cutoff x), `x` samples from the middle, but for a constant factor.
double windowed_sinc(const WindowedSinc& kernel, double x, double cutoff = 1);

/// Weights of the samples around a place that is `fraction` (0 to 1) after the sample of index
/// taps / 2 - 1. Their sum is 1, so that a constant stays exactly what it is.
WindowedSinc::PerTap interpolation_weights(const WindowedSinc& kernel, double fraction);

}  // namespace glare
