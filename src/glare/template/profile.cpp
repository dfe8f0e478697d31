#include "glare/template/profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glare/base/units.h"
#include "glare/scatter/straylight_pixels.h"

namespace glare {

namespace {

/// Distance of a pixel's centre from the axis, in pixels.
double radius_px(const GlareTemplate& t, int x, int y) {
  const auto center = t.center_px();
  return std::hypot(x - center[0], y - center[1]);
}

/// Distance from the axis to the nearest border of the pixels, in pixels.
double inscribed_radius_px(const GlareTemplate& t) {
  const auto center = t.center_px();
  return std::min(std::min(center[0] + 0.5, t.width() - center[0] - 0.5),
                  std::min(center[1] + 0.5, t.height() - center[1] - 0.5));
}

/// Share of a pixel's area within a circle about the axis, by 16 x 16 places.
double share_inside(double dx, double dy, double circle_px) {
  const double distance = std::hypot(dx, dy);
  if (distance + std::numbers::sqrt2 / 2 <= circle_px) return 1;
  if (distance - std::numbers::sqrt2 / 2 >= circle_px) return 0;
  constexpr int kPlaces = 16;
  int inside = 0;
  for (int j = 0; j < kPlaces; ++j)
    for (int i = 0; i < kPlaces; ++i)
      inside +=
          std::hypot(dx - 0.5 + (i + 0.5) / kPlaces, dy - 0.5 + (j + 0.5) / kPlaces) <= circle_px;
  return inside / static_cast<double>(kPlaces * kPlaces);
}

/// Outer radii of the rings, in pixels, ascending.
std::vector<double> ring_radii_px(double last_px) {
  const double factor = std::pow(10.0, 0.1);
  std::vector<double> radii = {0.5};
  while (radii.back() < last_px)
    radii.push_back(std::min(last_px, std::max(radii.back() + 1, radii.back() * factor)));
  return radii;
}

/// The number of the ring with a radius in it; that of the rings where it is beyond them.
std::size_t ring_of(double radius_px, const std::vector<double>& radii) {
  return static_cast<std::size_t>(std::lower_bound(radii.begin(), radii.end(), radius_px) -
                                  radii.begin());
}

/// The general equation's mean over the pixels of the ring between two radii. The pixels of one
/// quadrant are enough: the rings lie within the picture, and have their mirror images in it.
double cie_ring_mean(const GlareTemplate& t, const Straylight& eye, double inner_px,
                     double outer_px) {
  const double pitch = t.pixel_pitch_rad;
  double sum = 0, count = 0;
  for (int y = 0; y <= outer_px; ++y) {
    const double least = std::sqrt(std::max(0.0, inner_px * inner_px - 1.0 * y * y));
    for (int x = static_cast<int>(least); std::hypot(x, y) <= outer_px; ++x) {
      if (std::hypot(x, y) <= inner_px) continue;
      const double times = (x == 0 ? 1 : 2) * (y == 0 ? 1 : 2);
      sum += times * cie_pixel_mean(eye, x * pitch, y * pitch, pitch);
      count += times;
    }
  }
  return sum / count;
}

}  // namespace

std::vector<ProfileRing> radial_profile(const GlareTemplate& t) {
  const std::vector<double> radii = ring_radii_px(inscribed_radius_px(t));
  std::vector<double> sum(radii.size(), 0.0);
  std::vector<int> count(radii.size(), 0);
  for (int y = 0; y < t.height(); ++y)
    for (int x = 0; x < t.width(); ++x) {
      const std::size_t i = ring_of(radius_px(t, x, y), radii);
      if (i == radii.size()) continue;
      sum[i] += t.luminance(x, y);
      ++count[i];
    }
  std::vector<ProfileRing> rings;
  for (std::size_t i = 0; i < radii.size(); ++i)
    if (count[i] > 0)
      rings.push_back({(i ? radii[i - 1] : 0) * t.pixel_pitch_deg(), radii[i] * t.pixel_pitch_deg(),
                       sum[i] / count[i] * t.per_steradian});
  return rings;
}

std::vector<std::optional<double>> cie_profile(const GlareTemplate& t,
                                               const std::vector<ProfileRing>& rings,
                                               const Straylight& eye) {
  require_valid(eye);
  std::vector<std::optional<double>> means;
  for (const ProfileRing& ring : rings) {
    const double inner_rad = ring.inner_deg * kRadPerDeg, outer_rad = ring.outer_deg * kRadPerDeg;
    const bool within = inner_rad >= std::sin(kSmallestCieAngle_deg * kRadPerDeg) && outer_rad <= 1;
    means.emplace_back();
    if (within)
      means.back() =
          cie_ring_mean(t, eye, inner_rad / t.pixel_pitch_rad, outer_rad / t.pixel_pitch_rad);
  }
  return means;
}

std::optional<double> encircled_energy(const GlareTemplate& t, double radius_deg) {
  const double circle_px = radius_deg * kRadPerDeg / t.pixel_pitch_rad;
  if (circle_px < 1 || circle_px > inscribed_radius_px(t)) return std::nullopt;
  const auto center = t.center_px();
  const int reach = static_cast<int>(std::ceil(circle_px)) + 1;
  double sum = 0;
  for (int y = std::max(0, center[1] - reach); y <= std::min(t.height() - 1, center[1] + reach);
       ++y)
    for (int x = std::max(0, center[0] - reach); x <= std::min(t.width() - 1, center[0] + reach);
         ++x)
      sum += t.luminance(x, y) * share_inside(x - center[0], y - center[1], circle_px);
  return sum * t.per_steradian * t.pixel_pitch_rad * t.pixel_pitch_rad;
}

Peak peak(const GlareTemplate& t) {
  Peak result{0, 0, t.luminance(0, 0)};
  for (int y = 0; y < t.height(); ++y)
    for (int x = 0; x < t.width(); ++x)
      if (const double luminance = t.luminance(x, y); luminance > result.luminance)
        result = {x, y, luminance};
  return result;
}

Chromaticity mean_chromaticity(const GlareTemplate& t) {
  Vector3 sum{};
  for (std::size_t k = 0; k < sum.size(); ++k)
    for (const float value : t.channels[k].values()) sum[k] += value;
  return chromaticity(t.color_space.xyz_from_rgb() * sum);
}

}  // namespace glare
