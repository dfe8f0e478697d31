// Means of a sampled, band-limited function over intervals. Internal.
#pragma once

#include <span>
#include <vector>

#include "glare/integration/windowed_sinc.h"

namespace glare {

/// The mean of a function over [left, right], from its samples at the integers:
/// sum over j of weights[j] * sample[first + j].
struct BoxWeights {
  int first = 0;
  std::vector<float> weights;
};

/// Interpolates between samples with a windowed sinc, normalised so that a constant stays exactly
/// what it is, and integrates the interpolant over intervals by a table of the kernel's running
/// integral.
class BoxInterpolation {
 public:
  explicit BoxInterpolation(const WindowedSinc& kernel = kInterpolatingKernel);

  /// Weights for each interval between neighbouring `edges`, which ascend: one fewer than edges.
  void weights_between(std::span<const double> edges, std::vector<BoxWeights>& result) const;

 private:
  using PerTap = WindowedSinc::PerTap;

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
