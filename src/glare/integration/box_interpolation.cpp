#include "glare/integration/box_interpolation.h"

#include <cmath>

namespace glare {

BoxInterpolation::BoxInterpolation(const WindowedSinc& kernel)
    : taps_(kernel.taps), running_(kStepsPerSample + 1) {
  // The running integral of each tap across one sample's width, by Simpson's rule; then each tap
  // starts with what the taps that a sample has been before have gathered over the whole width.
  constexpr double step = 1.0 / kStepsPerSample;
  PerTap sum{};
  auto left = interpolation_weights(kernel, 0);
  for (int i = 0; i <= kStepsPerSample; ++i) {
    running_[i] = sum;
    const auto middle = interpolation_weights(kernel, (i + 0.5) * step);
    const auto right = interpolation_weights(kernel, (i + 1) * step);
    for (int j = 0; j < taps_; ++j) sum[j] += step / 6 * (left[j] + 4 * middle[j] + right[j]);
    left = right;
  }
  const PerTap whole = running_.back();
  PerTap before{};
  for (int j = taps_ - 2; j >= 0; --j) before[j] = before[j + 1] + whole[j + 1];
  for (PerTap& row : running_)
    for (int j = 0; j < taps_; ++j) row[j] += before[j];
}

double BoxInterpolation::Edge::running_of(int sample) const {
  const int j = sample - first;
  if (j < 0) return 1;
  if (j >= taps) return 0;
  return running[j];
}

BoxInterpolation::Edge BoxInterpolation::edge_at(double position) const {
  const double floor = std::floor(position);
  const double steps = (position - floor) * kStepsPerSample;
  const int i = static_cast<int>(steps);
  const double share = steps - i;
  Edge edge;
  edge.first = static_cast<int>(floor) - taps_ / 2 + 1;
  edge.taps = taps_;
  const PerTap& lower = running_[i];
  const PerTap& upper = running_[i + (i < kStepsPerSample ? 1 : 0)];
  for (int j = 0; j < taps_; ++j) edge.running[j] = lower[j] + share * (upper[j] - lower[j]);
  return edge;
}

void BoxInterpolation::weights_between(std::span<const double> edges,
                                       std::vector<BoxWeights>& result) const {
  result.resize(edges.size() - 1);
  Edge left = edge_at(edges[0]);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge right = edge_at(edges[i + 1]);
    const double per_sample = 1 / (edges[i + 1] - edges[i]);
    const int end = right.first + taps_;
    BoxWeights& box = result[i];
    box.first = left.first;
    box.weights.resize(static_cast<std::size_t>(end - box.first));
    for (int sample = box.first; sample < end; ++sample)
      box.weights[static_cast<std::size_t>(sample - box.first)] =
          static_cast<float>((right.running_of(sample) - left.running_of(sample)) * per_sample);
    left = right;
  }
}

}  // namespace glare
