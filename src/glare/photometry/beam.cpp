#include "glare/photometry/beam.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <vector>

#include "glare/base/units.h"

namespace glare {

namespace {

/// The weight of each angle in the integral of a function that is linear between them, over dt.
std::vector<double> linear_weights(const std::vector<double>& angles_deg) {
  std::vector<double> weights(angles_deg.size());
  for (std::size_t i = 0; i + 1 < angles_deg.size(); ++i) {
    const double half_step = (angles_deg[i + 1] - angles_deg[i]) * kRadPerDeg / 2;
    weights[i] += half_step;
    weights[i + 1] += half_step;
  }
  return weights;
}

/// The same over cos t dt: of a step from a to b the first angle gets the integral of
/// (b - t) / (b - a) cos t, which is (cos a - cos b) / (b - a) - sin a, and the second the rest.
std::vector<double> cosine_weights(const std::vector<double>& angles_deg, double middle_deg) {
  std::vector<double> weights(angles_deg.size());
  for (std::size_t i = 0; i + 1 < angles_deg.size(); ++i) {
    const double a = (angles_deg[i] - middle_deg) * kRadPerDeg;
    const double b = (angles_deg[i + 1] - middle_deg) * kRadPerDeg;
    const double mean_sine = 2 * std::sin((a + b) / 2) * std::sin((b - a) / 2) / (b - a);
    weights[i] += mean_sine - std::sin(a);
    weights[i + 1] += std::sin(b) - mean_sine;
  }
  return weights;
}

/// Intensity along a path, in the order of the place on it.
struct Profile {
  std::vector<double> places_deg, candela;
};

/// Where, from the peak on towards one end (`step` 1 or -1), the intensity first is `level`.
std::optional<double> crossing_deg(const Profile& profile, std::size_t peak, int step,
                                   double level) {
  const auto end = step > 0 ? profile.candela.size() - 1 : std::size_t{0};
  for (std::size_t i = peak; i != end; i += static_cast<std::size_t>(step)) {
    const std::size_t next = i + static_cast<std::size_t>(step);
    if (profile.candela[next] > level) continue;
    const double fall = profile.candela[i] - profile.candela[next];
    const double share = fall > 0 ? (profile.candela[i] - level) / fall : 0;
    return profile.places_deg[i] + share * (profile.places_deg[next] - profile.places_deg[i]);
  }
  return std::nullopt;
}

std::optional<double> full_width_deg(const Profile& profile, double peak_deg, double level) {
  const auto found =
      std::lower_bound(profile.places_deg.begin(), profile.places_deg.end(), peak_deg - 1e-9);
  const auto peak = static_cast<std::size_t>(found - profile.places_deg.begin());
  if (peak >= profile.places_deg.size()) return std::nullopt;
  const auto low_deg = crossing_deg(profile, peak, -1, level);
  const auto high_deg = crossing_deg(profile, peak, 1, level);
  if (!low_deg || !high_deg) return std::nullopt;
  return *high_deg - *low_deg;
}

/// Along one angle, over all that was measured; a closed circle is unrolled to both sides.
Profile profile_along(const std::vector<double>& angles_deg, double peak_deg,
                      const std::function<double(double)>& candela) {
  Profile profile;
  const bool closed = angles_deg.back() - angles_deg.front() >= 360 - 1e-6;
  for (const double turn_deg : {-360.0, 0.0, 360.0})
    for (const double angle_deg : angles_deg) {
      const double place_deg = angle_deg + turn_deg;
      if (turn_deg != 0 && !closed) continue;
      if (closed && std::abs(place_deg - peak_deg) > 180) continue;
      if (!profile.places_deg.empty() && place_deg - profile.places_deg.back() < 1e-9) continue;
      profile.places_deg.push_back(place_deg);
      profile.candela.push_back(candela(angle_deg));
    }
  return profile;
}

/// Along gamma in the peak's plane and, below 0 and above 180, in the opposite one; around the
/// circle as far as it was measured without a gap.
Profile profile_in_plane(const LuminousIntensityDistribution& distribution,
                         const PeakIntensity& peak) {
  const std::vector<double>& gamma_deg = distribution.vertical_deg();
  const bool over_zero = gamma_deg.front()<1e-6, over_180 = gamma_deg.back()> 180 - 1e-6;
  std::vector<double> places_deg = gamma_deg;
  for (const double gamma : gamma_deg) {
    if (over_zero) places_deg.push_back(-gamma);
    if (over_180) places_deg.push_back(360 - gamma);
    if (over_zero && over_180) places_deg.push_back(gamma - 360);
  }
  std::sort(places_deg.begin(), places_deg.end());
  Profile profile;
  for (const double place_deg : places_deg) {
    if (std::abs(place_deg - peak.vertical_deg) > 180) continue;
    if (!profile.places_deg.empty() && place_deg - profile.places_deg.back() < 1e-9) continue;
    profile.places_deg.push_back(place_deg);
    profile.candela.push_back(distribution(peak.horizontal_deg, place_deg));
  }
  return profile;
}

/// The great circle through the peak that is perpendicular to its plane.
class CircleAcross {
 public:
  CircleAcross(const LuminousIntensityDistribution& distribution, const PeakIntensity& peak)
      : distribution_(distribution),
        ahead_(direction_from_angles(PhotometricType::c, peak.horizontal_deg, peak.vertical_deg)),
        aside_(direction_from_angles(PhotometricType::c, peak.horizontal_deg + 90, 90)) {}

  /// Where, from the peak on to one side (1 or -1), the intensity first is `level`, as an angle
  /// from the peak. Nothing where it isn't before what was measured ends.
  std::optional<double> half_width_deg(int side, double level) const {
    constexpr double kStep_deg = 0.05, kPrecision_deg = 1e-9;  // Finer than beams are structured.
    for (int i = 1; i * kStep_deg <= 180; ++i) {
      const auto reached = candela(side * i * kStep_deg);
      if (!reached) return std::nullopt;
      if (*reached > level) continue;
      double inner_deg = (i - 1) * kStep_deg, outer_deg = i * kStep_deg;
      while (outer_deg - inner_deg > kPrecision_deg) {
        const double middle_deg = (inner_deg + outer_deg) / 2;
        (candela(side * middle_deg).value_or(0) > level ? inner_deg : outer_deg) = middle_deg;
      }
      return outer_deg;
    }
    return std::nullopt;
  }

 private:
  std::optional<double> candela(double place_deg) const {
    const double cosine = std::cos(place_deg * kRadPerDeg), sine = std::sin(place_deg * kRadPerDeg);
    Vector3 direction;
    for (std::size_t k = 0; k < 3; ++k) direction[k] = cosine * ahead_[k] + sine * aside_[k];
    const auto [c, gamma] = photometric_angles_deg(PhotometricType::c, direction);
    const std::vector<double>& measured_deg = distribution_.vertical_deg();
    if (gamma < measured_deg.front() - 1e-6 || gamma > measured_deg.back() + 1e-6)
      return std::nullopt;
    return distribution_(c, gamma);
  }

  const LuminousIntensityDistribution& distribution_;
  Vector3 ahead_, aside_;
};

std::optional<double> width_across_deg(const LuminousIntensityDistribution& distribution,
                                       const PeakIntensity& peak, double level) {
  const CircleAcross circle(distribution, peak);
  const auto left_deg = circle.half_width_deg(-1, level);
  const auto right_deg = circle.half_width_deg(1, level);
  if (!left_deg || !right_deg) return std::nullopt;
  return *left_deg + *right_deg;
}

}  // namespace

double luminous_flux_lm(const LuminousIntensityDistribution& distribution) {
  const bool b = distribution.type() == PhotometricType::b;
  const double middle_deg = distribution.type() == PhotometricType::c ? 90 : 0;
  const auto columns = b ? cosine_weights(distribution.horizontal_deg(), 0)
                         : linear_weights(distribution.horizontal_deg());
  const auto rows = b ? linear_weights(distribution.vertical_deg())
                      : cosine_weights(distribution.vertical_deg(), middle_deg);
  double flux_lm = 0;
  for (int j = 0; j < distribution.candela().height(); ++j) {
    double row = 0;
    for (int i = 0; i < distribution.candela().width(); ++i)
      row += columns[static_cast<std::size_t>(i)] * distribution.candela()(i, j);
    flux_lm += rows[static_cast<std::size_t>(j)] * row;
  }
  return flux_lm;
}

PeakIntensity peak_intensity(const LuminousIntensityDistribution& distribution) {
  const auto values = distribution.candela().values();
  const auto peak = std::max_element(values.begin(), values.end()) - values.begin();
  const auto width = static_cast<std::ptrdiff_t>(distribution.horizontal_deg().size());
  return {values[static_cast<std::size_t>(peak)],
          distribution.horizontal_deg()[static_cast<std::size_t>(peak % width)],
          distribution.vertical_deg()[static_cast<std::size_t>(peak / width)]};
}

BeamWidths beam_widths(const LuminousIntensityDistribution& distribution, double share) {
  assert(share > 0 && share < 1);
  const PeakIntensity peak = peak_intensity(distribution);
  if (peak.candela <= 0) return {};
  const double level = share * peak.candela;
  if (distribution.type() == PhotometricType::c)
    return {width_across_deg(distribution, peak, level),
            full_width_deg(profile_in_plane(distribution, peak), peak.vertical_deg, level)};
  const Profile along_h =
      profile_along(distribution.horizontal_deg(), peak.horizontal_deg,
                    [&](double h) { return distribution(h, peak.vertical_deg); });
  const Profile along_v =
      profile_along(distribution.vertical_deg(), peak.vertical_deg,
                    [&](double v) { return distribution(peak.horizontal_deg, v); });
  return {full_width_deg(along_h, peak.horizontal_deg, level),
          full_width_deg(along_v, peak.vertical_deg, level)};
}

}  // namespace glare
