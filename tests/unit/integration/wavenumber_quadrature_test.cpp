#include "glare/integration/wavenumber_quadrature.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "glare/spectrum/lamps.h"

namespace glare {
namespace {

constexpr WavelengthRange kRange{380, 780};
constexpr double kPerMm = 1e6;  // nm in a mm: 1 / lambda in mm^-1 is 1e6 / lambda in nm.

const ColorMatchingFunctions& observer() { return color_matching_functions("cie1931-2deg"); }

/// The integral that the quadrature stands for, by midpoints 0.002 nm apart.
template <typename Intensity>
Xyz direct(const Spectrum& lamp, const WavelengthRange& range, const Intensity& intensity) {
  constexpr double kStep_nm = 0.002;
  const int steps = static_cast<int>(std::lround((range.hi_nm - range.lo_nm) / kStep_nm));
  Xyz sum{};
  double luminance = 0;
  for (int i = 0; i < steps; ++i) {
    const double nm = range.lo_nm + (i + 0.5) * kStep_nm, nu = kPerMm / nm;
    const double light = lamp(nm) * nu * nu * intensity(nu);
    sum[0] += light * observer().x_bar(nm);
    sum[1] += light * observer().y_bar(nm);
    sum[2] += light * observer().z_bar(nm);
    luminance += lamp(nm) * observer().y_bar(nm);
  }
  for (double& s : sum) s /= luminance;
  return sum;
}

template <typename Intensity>
Xyz by_quadrature(const WavenumberQuadrature& q, const Intensity& intensity) {
  Xyz sum{};
  for (std::size_t k = 0; k < q.weights.size(); ++k)
    for (int c = 0; c < 3; ++c) sum[c] += q.weights[k][c] * intensity(q.wavenumbers_per_mm[k]);
  return sum;
}

void expect_same(const Xyz& found, const Xyz& expected, double tolerance) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(found[c] / expected[1], expected[c] / expected[1], tolerance);
}

TEST(WavenumberQuadrature, NodesAreEvenInWavenumberFromEndToEnd) {
  const auto q = wavenumber_quadrature(*find_lamp("A"), observer(), kRange, 33);
  ASSERT_EQ(q.wavenumbers_per_mm.size(), 33u);
  ASSERT_EQ(q.weights.size(), 33u);
  EXPECT_DOUBLE_EQ(q.wavenumbers_per_mm.front(), kPerMm / 780);
  EXPECT_DOUBLE_EQ(q.wavenumbers_per_mm.back(), kPerMm / 380);
  for (int k = 1; k < 33; ++k)
    EXPECT_NEAR(q.wavenumbers_per_mm[k] - q.wavenumbers_per_mm[k - 1],
                (kPerMm / 380 - kPerMm / 780) / 32, 1e-9);
}

TEST(WavenumberQuadrature, IsExactForCubicsOfTheWavenumber) {
  const auto cubic = [](double nu) {
    const double t = nu / 2000;
    return 1 + t * (-2 + t * (0.7 + 0.4 * t));
  };
  for (const char* name : {"D65", "FL11", "LED-RGB1"})
    for (const int nodes : {4, 5, 12, 100}) {
      const Spectrum lamp = *find_lamp(name);
      expect_same(by_quadrature(wavenumber_quadrature(lamp, observer(), kRange, nodes), cubic),
                  direct(lamp, kRange, cubic),
                  1e-5);  // Single precision; few nodes, large weights.
      const auto one = [](double) { return 1.0; };
      expect_same(by_quadrature(wavenumber_quadrature(lamp, observer(), kRange, nodes), one),
                  direct(lamp, kRange, one), 1e-5);
    }
}

TEST(WavenumberQuadrature, KeepsALineThatFallsBetweenItsNodes) {
  for (const double nm : {404.66, 546.07, 611.3}) {
    const Spectrum line({nm - 0.05, nm, nm + 0.05}, {0, 1, 0});
    const auto q = wavenumber_quadrature(line, observer(), {nm - 20, nm + 31}, 6);
    const auto wave = [](double nu) { return 2 + std::cos(nu / 200); };
    const double expected = wave(kPerMm / nm) * kPerMm * kPerMm / (nm * nm);
    const double found = by_quadrature(q, wave)[1];
    EXPECT_NEAR(found / expected, 1, 1e-3) << nm;  // A cubic for a cosine, 0.3 rad a node.
  }
}

TEST(WavenumberQuadrature, FollowsAWaveOfThreeNodesACycleAndMore) {
  const Spectrum lamp = *find_lamp("HP5");
  const double span = kPerMm / 380 - kPerMm / 780;
  struct Case {
    double nodes_per_cycle, error;  // A share of the wave's amplitude.
  };
  for (const Case c : {Case{3, 3e-3}, {6, 1e-3}, {12, 1e-4}}) {
    constexpr double kCycles = 60;
    const auto wave = [&](double nu) {
      return 1 + std::cos(2 * std::numbers::pi * kCycles * nu / span);
    };
    const auto nodes = static_cast<int>(48 + c.nodes_per_cycle * kCycles);
    expect_same(by_quadrature(wavenumber_quadrature(lamp, observer(), kRange, nodes), wave),
                direct(lamp, kRange, wave),
                c.error * direct(lamp, kRange, wave)[1] /
                    direct(lamp, kRange, [](double) { return 1.0; })[1]);
  }
}

}  // namespace
}  // namespace glare
