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

/// Interpolates between samples with a windowed sinc (Kaiser's window, 8 taps wide, normalised so
/// that a constant stays exactly what it is) and integrates the interpolant over intervals, by a
/// table of the kernel's running integral. Meant for samples at twice the critical rate or more;
/// at the critical rate for intervals of several samples, which average.
class BoxInterpolation {
 public:
  static constexpr int kTaps = 8;

  BoxInterpolation();

  /// Weights for each interval between neighbouring `edges`, which ascend: one fewer than edges.
  void weights_between(std::span<const double> edges, std::vector<BoxWeights>& result) const;

 private:
  struct Edge {
    int floor;
    /// The kernel's integral up to the edge, for samples floor - 3 to floor + 4. Samples before
    /// them lie wholly to the left (1), samples after them wholly to the right (0).
    std::array<double, kTaps> running;

    double running_of(int sample) const;
  };
  Edge edge_at(double position) const;

  static constexpr int kStepsPerSample = 1024;
  std::vector<std::array<double, kTaps>> running_;  ///< By the fraction of the edge's position.
};

}  // namespace glare
