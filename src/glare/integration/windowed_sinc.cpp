#include "glare/integration/windowed_sinc.h"

#include <cmath>
#include <numbers>

namespace glare {

namespace {

/// The modified Bessel function I0 by its series; x^2 / 4 < 40.
double bessel_i0(double x) {
  const double quarter = x * x / 4;
  double sum = 1, term = 1;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= quarter / (k * k);
    sum += term;
  }
  return sum;
}

}  // namespace

double windowed_sinc(const WindowedSinc& kernel, double x, double cutoff) {
  const double u = x / (kernel.taps / 2);
  if (std::abs(u) > 1) return 0;
  const double angle = std::numbers::pi * cutoff * x;
  const double sinc = std::abs(angle) < 1e-12 ? 1 : std::sin(angle) / angle;
  return sinc * bessel_i0(kernel.kaiser_beta * std::sqrt(1 - u * u));
}

WindowedSinc::PerTap interpolation_weights(const WindowedSinc& kernel, double fraction) {
  WindowedSinc::PerTap weights{};
  double sum = 0;
  for (int j = 0; j < kernel.taps; ++j)
    sum += weights[j] = windowed_sinc(kernel, fraction + kernel.taps / 2 - 1 - j);
  for (double& w : weights) w /= sum;
  return weights;
}

}  // namespace glare
