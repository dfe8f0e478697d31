#include "glare/integration/wavenumber_quadrature.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "glare/base/units.h"

namespace glare {

namespace {

/// Nodes and weights of the 4-point Gauss-Legendre rule on [-1, 1] (Abramowitz and Stegun 25.4).
constexpr std::array<double, 4> kGaussNode = {-0.861136311594052575224, -0.339981043584856264803,
                                              0.339981043584856264803, 0.861136311594052575224};
constexpr std::array<double, 4> kGaussWeight = {0.347854845137453857373, 0.652145154862546142627,
                                                0.652145154862546142627, 0.347854845137453857373};

/// Lagrange's polynomials of the nodes 0, 1, 2, 3 at t.
std::array<double, 4> cubic_basis(double t) {
  const double a = t, b = t - 1, c = t - 2, d = t - 3;
  return {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
}

/// The evenly spaced wavenumbers and, with them, the place of a wavelength among them.
struct Nodes {
  double first_per_mm;
  double step_per_mm;
  int count;

  Nodes(const WavelengthRange& range, int node_count)
      : first_per_mm(1 / (range.hi_nm * kMmPerNm)),
        step_per_mm((1 / (range.lo_nm * kMmPerNm) - first_per_mm) / (node_count - 1)),
        count(node_count) {}

  double wavelength_nm(int k) const { return 1 / ((first_per_mm + k * step_per_mm) * kMmPerNm); }
  double position(double wavelength_nm) const {
    return (1 / (wavelength_nm * kMmPerNm) - first_per_mm) / step_per_mm;
  }
};

/// Wavelengths between which the spectra are linear and the interpolating cubic stays the same one.
std::vector<double> breakpoints_nm(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                                   const WavelengthRange& range, const Nodes& nodes) {
  const std::array<const Spectrum*, 2> spectra = {&lamp, &observer.y_bar};
  std::vector<double> points = union_of_knots(spectra, range);
  for (int k = 1; k < nodes.count - 1; ++k) points.push_back(nodes.wavelength_nm(k));
  std::sort(points.begin(), points.end());
  return points;
}

/// Adds the share of one wavelength, whose light is `xyz` mm^-2, to the nodes around it.
void add_to_nodes(const Nodes& nodes, double wavelength_nm, int first_node, const Xyz& xyz,
                  std::vector<Xyz>& sums) {
  const auto basis = cubic_basis(nodes.position(wavelength_nm) - first_node);
  for (int j = 0; j < 4; ++j)
    for (int k = 0; k < 3; ++k) sums[first_node + j][k] += basis[j] * xyz[k];
}

/// Integrates S (x̄, ȳ, z̄) / lambda^2 over [lo, hi] nm, times the cubic basis.
void integrate_interval(const Spectrum& lamp, const ColorMatchingFunctions& observer, double lo,
                        double hi, const Nodes& nodes, std::vector<Xyz>& sums) {
  const double middle = (lo + hi) / 2, half = (hi - lo) / 2;
  const int interval = static_cast<int>(std::floor(nodes.position(middle)));
  const int first_node = std::clamp(interval - 1, 0, nodes.count - 4);
  for (int g = 0; g < 4; ++g) {
    const double nm = middle + half * kGaussNode[g];
    const double lambda_mm = nm * kMmPerNm;
    const double light = half * kGaussWeight[g] * lamp(nm) / (lambda_mm * lambda_mm);
    add_to_nodes(
        nodes, nm, first_node,
        {light * observer.x_bar(nm), light * observer.y_bar(nm), light * observer.z_bar(nm)}, sums);
  }
}

}  // namespace

WavenumberQuadrature wavenumber_quadrature(const Spectrum& lamp,
                                           const ColorMatchingFunctions& observer,
                                           const WavelengthRange& range, int node_count) {
  assert(node_count >= 4 && !range.empty());
  const Nodes nodes(range, node_count);
  std::vector<Xyz> sums(static_cast<std::size_t>(node_count), Xyz{0, 0, 0});
  const std::vector<double> points = breakpoints_nm(lamp, observer, range, nodes);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i] > points[i - 1])
      integrate_interval(lamp, observer, points[i - 1], points[i], nodes, sums);

  const double luminance = luminous_integral(lamp, observer, range);
  WavenumberQuadrature quadrature;
  for (int k = 0; k < node_count; ++k) {
    quadrature.wavenumbers_per_mm.push_back(nodes.first_per_mm + k * nodes.step_per_mm);
    const Xyz& sum = sums[static_cast<std::size_t>(k)];
    quadrature.weights.push_back({static_cast<float>(sum[0] / luminance),
                                  static_cast<float>(sum[1] / luminance),
                                  static_cast<float>(sum[2] / luminance)});
  }
  return quadrature;
}

}  // namespace glare
