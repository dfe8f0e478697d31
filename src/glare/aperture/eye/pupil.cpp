#include "glare/aperture/eye/pupil.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "glare/aperture/eye/random.h"

namespace glare {

namespace {

/// Waves around the pupil: from `first` to `last` of them, sum over k of
/// weight_k cos(k angle + phase_k), with a root mean square of `rms_mm`.
struct Waves {
  int first, last;
  double rms_mm;
  std::vector<std::complex<double>> amplitudes;

  /// Weights fall as 1 / k^`falling`.
  Waves(int first_, int last_, double rms, double falling, SplitMix& random)
      : first(first_), last(last_), rms_mm(rms) {
    double power = 0;
    for (int k = first; k <= last; ++k) {
      const double weight = std::pow(k, -falling);
      amplitudes.push_back(std::polar(weight, random.between(0, 2 * std::numbers::pi)));
      power += weight * weight / 2;
    }
    for (auto& amplitude : amplitudes) amplitude *= rms / std::sqrt(power);
  }

  /// At the angle whose e^(i angle) is `turn`; smoothly kept within three times the root mean
  /// square, so that there is a farthest that a pupil reaches.
  double at(std::complex<double> turn) const {
    if (rms_mm == 0) return 0;
    std::complex<double> power = std::pow(turn, first);
    double sum = 0;
    for (const auto& amplitude : amplitudes) {
      sum += amplitude.real() * power.real() - amplitude.imag() * power.imag();
      power *= turn;
    }
    return limited(sum, 3 * rms_mm);
  }
};

/// Distance from the centre to an ellipse of the area of a unit disc, `angle` from its longer axis.
double ellipse_radius(double axis_ratio, double angle) {
  const double eccentricity_squared = 1 - axis_ratio * axis_ratio;
  const double c = std::cos(angle);
  return std::sqrt(axis_ratio / (1 - eccentricity_squared * c * c));
}

}  // namespace

std::vector<Point> pupil_outline(const PupilParameters& p, std::uint64_t seed, double diameter_mm) {
  constexpr int vertex_count = 8192;
  SplitMix random = random_for(seed, EyePart::pupil);
  const Waves crypts(3, 12, p.crypt_irregularity_mm, 1, random);
  const Waves ruff(20, 80, p.ruff_irregularity_mm, 0, random);
  const double tilt = p.longer_axis_deg * std::numbers::pi / 180;

  std::vector<Point> vertices;
  for (int i = 0; i < vertex_count; ++i) {
    const double angle = 2 * std::numbers::pi * i / vertex_count;
    const std::complex<double> turn = std::polar(1.0, angle);
    const double radius = p.diameter_mm / 2 * ellipse_radius(p.axis_ratio, angle - tilt) +
                          crypts.at(turn) + ruff.at(turn);
    vertices.push_back({radius * turn.real(), -radius * turn.imag()});
  }
  const double area = std::abs(signed_area_mm2(vertices));
  const double scale = diameter_mm / 2 * std::sqrt(std::numbers::pi / area);
  const Point centre{p.decentring_x_mm, p.decentring_y_mm};
  for (Point& vertex : vertices) vertex = centre + scale * vertex;
  return vertices;
}

double pupil_reach_mm(const PupilParameters& p, double diameter_mm) {
  const double relative = 3 * (p.crypt_irregularity_mm + p.ruff_irregularity_mm) / p.diameter_mm;
  const double radius = diameter_mm * (0.5 / std::sqrt(p.axis_ratio) + relative);
  return radius + std::max(std::abs(p.decentring_x_mm), std::abs(p.decentring_y_mm));
}

}  // namespace glare
