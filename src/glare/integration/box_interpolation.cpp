#include "glare/integration/box_interpolation.h"

#include <cmath>
#include <numbers>

namespace glare {

namespace {

constexpr int kHalfWidth = BoxInterpolation::kTaps / 2;

/// Shape of Kaiser's window: balances the ripple in the pass band against the images that remain,
/// for samples at twice the critical rate.
constexpr double kKaiserBeta = 6.5;

double windowed_sinc(double s) {
  const double u = s / kHalfWidth;
  if (std::abs(u) >= 1) return 0;
  const double x = std::numbers::pi * s;
  const double sinc = std::abs(x) < 1e-12 ? 1 : std::sin(x) / x;
  return sinc * std::cyl_bessel_i(0.0, kKaiserBeta * std::sqrt(1 - u * u)) /
         std::cyl_bessel_i(0.0, kKaiserBeta);
}

/// Weights of samples -3 to 4 for a place `fraction` after sample 0; their sum is 1.
std::array<double, BoxInterpolation::kTaps> interpolation_weights(double fraction) {
  std::array<double, BoxInterpolation::kTaps> weights;
  double sum = 0;
  for (int j = 0; j < BoxInterpolation::kTaps; ++j)
    sum += weights[j] = windowed_sinc(fraction + kHalfWidth - 1 - j);
  for (double& w : weights) w /= sum;
  return weights;
}

}  // namespace

BoxInterpolation::BoxInterpolation() : running_(kStepsPerSample + 1) {
  // The running integral of each tap's kernel across one sample's width, by Simpson's rule; then
  // what each tap has gathered by the end of the width is passed to its neighbour on the right.
  constexpr double step = 1.0 / kStepsPerSample;
  std::array<double, kTaps> sum{};
  auto left = interpolation_weights(0);
  for (int i = 0; i <= kStepsPerSample; ++i) {
    running_[i] = sum;
    const auto middle = interpolation_weights((i + 0.5) * step);
    const auto right = interpolation_weights((i + 1) * step);
    for (int j = 0; j < kTaps; ++j) sum[j] += step / 6 * (left[j] + 4 * middle[j] + right[j]);
    left = right;
  }
  const auto whole = running_.back();
  std::array<double, kTaps> before{};
  for (int j = kTaps - 2; j >= 0; --j) before[j] = before[j + 1] + whole[j + 1];
  for (auto& row : running_)
    for (int j = 0; j < kTaps; ++j) row[j] += before[j];
}

double BoxInterpolation::Edge::running_of(int sample) const {
  const int j = sample - (floor - kHalfWidth + 1);
  if (j < 0) return 1;
  if (j >= kTaps) return 0;
  return running[j];
}

BoxInterpolation::Edge BoxInterpolation::edge_at(double position) const {
  const double floor = std::floor(position);
  const double steps = (position - floor) * kStepsPerSample;
  const int i = static_cast<int>(steps);
  const double share = steps - i;
  Edge edge{static_cast<int>(floor), {}};
  const auto& lower = running_[i];
  const auto& upper = running_[i + (i < kStepsPerSample ? 1 : 0)];
  for (int j = 0; j < kTaps; ++j) edge.running[j] = lower[j] + share * (upper[j] - lower[j]);
  return edge;
}

void BoxInterpolation::weights_between(std::span<const double> edges,
                                       std::vector<BoxWeights>& result) const {
  result.resize(edges.size() - 1);
  Edge left = edge_at(edges[0]);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge right = edge_at(edges[i + 1]);
    const double per_sample = 1 / (edges[i + 1] - edges[i]);
    const int last = right.floor + kHalfWidth;
    BoxWeights& box = result[i];
    box.first = left.floor - kHalfWidth + 1;
    box.weights.resize(static_cast<std::size_t>(last - box.first + 1));
    for (int sample = box.first; sample <= last; ++sample)
      box.weights[static_cast<std::size_t>(sample - box.first)] = static_cast<float>(
          (right.running_of(sample) - left.running_of(sample)) * per_sample);
    left = right;
  }
}

}  // namespace glare
