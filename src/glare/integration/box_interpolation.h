// Means of a sampled, band-limited function over intervals. Internal.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace glare {

/// The mean of a function over [left, right], from its samples at the integers:
/// sum over j of weights[j] * sample[first + j].
struct BoxWeights {
  int first = 0;
  std::vector<float> weights;
};

/// A sinc under Kaiser's window.
struct WindowedSinc {
  int taps;            ///< Samples that it takes in; even, at most `kMostTaps`.
  double kaiser_beta;  ///< The window's shape: more ripples less and passes less.

  static constexpr int kMostTaps = 12;
};

/// For samples at twice the critical rate or more: errs by at most 4e-5 of a cosine up to five
/// sixths of the finest detail there is, and by 8e-4 at that, of which a real pattern has next to
/// nothing (box_interpolation_test).
inline constexpr WindowedSinc kInterpolatingKernel{12, 10.5};

/// For samples at 1.25 times the critical rate or more and intervals of several samples, which
/// average: errs only in the detail that the mean takes away.
inline constexpr WindowedSinc kAveragingKernel{12, 8};

/// Interpolates between samples with a windowed sinc, normalised so that a constant stays exactly
/// what it is, and integrates the interpolant over intervals by a table of the kernel's running
/// integral.
class BoxInterpolation {
 public:
  explicit BoxInterpolation(const WindowedSinc& kernel = kInterpolatingKernel);

  /// Weights for each interval between neighbouring `edges`, which ascend: one fewer than edges.
  void weights_between(std::span<const double> edges, std::vector<BoxWeights>& result) const;

 private:
  /// A value for each tap of the kernel; those beyond its number of taps stay 0.
  using PerTap = std::array<double, WindowedSinc::kMostTaps>;

  struct Edge {
    int first = 0;  ///< The first sample that has a part of its kernel on either side of the edge.
    int taps = 0;
    /// The kernels' integrals up to the edge, from sample `first` on. Samples before lie wholly to
    /// the left (1), samples after wholly to the right (0).
    PerTap running{};

    double running_of(int sample) const;
  };
  Edge edge_at(double position) const;

  static constexpr int kStepsPerSample = 1024;
  int taps_;
  std::vector<PerTap> running_;  ///< By the fraction of the edge's position.
};

}  // namespace glare
