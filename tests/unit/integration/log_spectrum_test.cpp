#include "glare/integration/log_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "glare/base/units.h"
#include "glare/spectrum/lamps.h"

namespace glare {
namespace {

constexpr WavelengthRange kRange{380, 780};

const ColorMatchingFunctions& observer() { return color_matching_functions("cie1931-2deg"); }

Spectrum line_at(double nm) { return Spectrum({nm - 0.1, nm, nm + 0.1}, {0, 1, 0}); }

/// What the sum stands for, by the trapezoid rule at 0.002 nm, for I a function of ln nu.
template <typename Intensity>
Xyz direct(const Spectrum& lamp, const Intensity& intensity) {
  constexpr double kStep_nm = 0.002;
  const int steps = static_cast<int>(std::lround((kRange.hi_nm - kRange.lo_nm) / kStep_nm));
  Xyz sum{};
  double luminance = 0;
  for (int i = 0; i <= steps; ++i) {
    const double nm = kRange.lo_nm + i * kStep_nm, nu = 1 / (nm * kMmPerNm);
    const double power = lamp(nm) * (i == 0 || i == steps ? 0.5 : 1);
    const double light = power * nu * nu * intensity(std::log(nu));
    sum[0] += light * observer().x_bar(nm);
    sum[1] += light * observer().y_bar(nm);
    sum[2] += light * observer().z_bar(nm);
    luminance += power * observer().y_bar(nm);
  }
  for (double& s : sum) s /= luminance;
  return sum;
}

template <typename Intensity>
Xyz by_weights(const LogSpectrum& spectrum, const Intensity& intensity) {
  Xyz sum{};
  for (std::size_t i = 0; i < spectrum.weights.size(); ++i)
    for (int c = 0; c < 3; ++c)
      sum[c] += spectrum.weights[i][c] *
                intensity(spectrum.first_log_per_mm + static_cast<double>(i) * spectrum.log_step);
  return sum;
}

/// As shares of Y, by which all three are told apart.
void expect_same(const Xyz& found, const Xyz& expected, double tolerance) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(found[c] / expected[1], expected[c] / expected[1], tolerance) << c;
}

double one(double) { return 1; }

TEST(LogSpectrum, WeightsSumToTheIntegralOfTheLight) {
  // Two Gauss points integrate cubics exactly; 1 / lambda^2 over 5 nm of 380 isn't far from one.
  for (const char* name : {"A", "D65", "FL11", "HP5", "LED-RGB1"})
    for (const double step : {0.01, 0.0007}) {
      const Spectrum lamp = *find_lamp(name);
      expect_same(by_weights(log_spectrum(lamp, observer(), kRange, step), one), direct(lamp, one),
                  1e-6);
    }
}

TEST(LogSpectrum, FollowsWavesOverTheLogarithm) {
  // Three steps a period and more; the kernel of beta 8.5 errs by 3e-4 of a wave there at most
  // (`PointInterpolation.MeetsACosine` has four), and the light averages that.
  for (const char* name : {"D65", "FL11", "HP5"})
    for (const double steps_a_period : {3.3, 5.0, 20.0}) {
      constexpr double kStep = 0.004;
      const Spectrum lamp = *find_lamp(name);
      const auto wave = [&](double log) {
        return 1.5 + std::cos(2 * std::numbers::pi * log / (kStep * steps_a_period));
      };
      expect_same(by_weights(log_spectrum(lamp, observer(), kRange, kStep), wave),
                  direct(lamp, wave), 1e-3);
    }
}

TEST(LogSpectrum, MissesNoLineOfAFifthOfANanometre) {
  for (const double step : {0.01, 0.001})  // A line is 0.0004 wide.
    for (double nm = 400.03; nm < 700; nm += 7.31) {
      const Spectrum line = line_at(nm);
      const LogSpectrum spectrum = log_spectrum(line, observer(), kRange, step);
      const auto wave = [&](double log) { return 2 + std::cos(log / step); };  // 6.3 steps.
      const double nu = 1 / (nm * kMmPerNm);
      const double light = by_weights(spectrum, one)[1], waves = by_weights(spectrum, wave)[1];
      // The line's own width, 3e-4 nm / nm squared, and how ȳ changes over it.
      EXPECT_NEAR(light / (nu * nu), 1, 1e-5) << nm;
      // A width of half a step averages the wave by 1 - (0.4 / 2)^2 / 12; the kernel errs by 1e-3.
      EXPECT_NEAR(waves / light, wave(std::log(nu)), 1e-2) << nm;
    }
}

TEST(LogSpectrum, TakesOnlyTheLightOfItsRange) {
  const Spectrum lamp = *find_lamp("A");
  const auto whole = by_weights(log_spectrum(lamp, observer(), kRange, 0.002), one);
  const double all = luminous_integral(lamp, observer(), kRange);
  Xyz parts{};
  for (const WavelengthRange range : {WavelengthRange{380, 533.3}, {533.3, 780}}) {
    const Xyz part = by_weights(log_spectrum(lamp, observer(), range, 0.002), one);
    const double share = luminous_integral(lamp, observer(), range) / all;
    for (int c = 0; c < 3; ++c) parts[c] += share * part[c];
  }
  expect_same(parts, whole, 1e-7);  // Exact where both are linear, but for 1 / lambda^2.
}

TEST(LogSpectrum, ResampledIsTheSameLight) {
  for (const char* name : {"D65", "HP5"})
    for (const double step : {0.0013, 0.002, 0.005}) {
      const LogSpectrum fine = log_spectrum(*find_lamp(name), observer(), kRange, 0.001);
      const LogSpectrum coarse = resampled(fine, step);
      EXPECT_EQ(coarse.log_step, step);
      expect_same(by_weights(coarse, one), by_weights(fine, one), 1e-12);  // In double.
      // At five steps a period, the kernel errs by 2e-4 of the wave.
      const auto wave = [&](double log) {
        return 1.5 + std::cos(2 * std::numbers::pi * log / (5 * step));
      };
      expect_same(by_weights(coarse, wave), by_weights(fine, wave), 5e-4);
    }
}

TEST(DetailSpectrum, LinesLetMoreDetailThroughThanSmoothLamps) {
  const auto cutoff = [](const Spectrum& lamp) {
    return DetailSpectrum(log_spectrum(lamp, observer(), kRange, 0.0005)).cutoff(500, 0.005);
  };
  const double smooth = cutoff(*find_lamp("A"));
  EXPECT_GT(smooth, 0);
  EXPECT_GT(cutoff(*find_lamp("FL11")), 2 * smooth);
  EXPECT_GT(cutoff(line_at(546)), cutoff(*find_lamp("FL11")));
}

TEST(DetailSpectrum, LessMayBeNeglectedOfASmallerShare) {
  for (const char* name : {"A", "D65", "FL11"}) {
    const DetailSpectrum detail(log_spectrum(*find_lamp(name), observer(), kRange, 0.0005));
    double before = detail.cutoff(500, 1e-5);
    EXPECT_GT(before, detail.cutoff(500, 0.1)) << name;
    for (double share = 2e-5; share < 1; share *= 1.5) {
      EXPECT_LE(detail.cutoff(500, share), before) << name << " " << share;
      before = detail.cutoff(500, share);
    }
    EXPECT_EQ(detail.cutoff(500, 1), 0) << name;  // All of it.
  }
}

}  // namespace
}  // namespace glare
