#include "glare/integration/ray_band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace glare {
namespace {

constexpr WavelengthRange kRange{380, 780};
constexpr double kExtent_mm = 4;
constexpr double kCycle_rad = 380e-6 / kExtent_mm;  ///< The finest detail there is.

/// A field of which only the sampling counts.
FarField field_of(double extent_y_mm = kExtent_mm) {
  FarField field;
  field.extent_x_mm = kExtent_mm;
  field.extent_y_mm = extent_y_mm;
  field.bin_x_per_mm = 1 / (4 * kExtent_mm);
  field.bin_y_per_mm = 1 / (4 * extent_y_mm);
  return field;
}

struct Plane {
  PixelGrid grid;
  SubPixels sub;
  double extent_y_mm;
  int begin_px;
  std::vector<RayBand> bands;
};

Plane plane_of(int width, int height, double pixel_cycles, double extent_y_mm = kExtent_mm) {
  const FarField field = field_of(extent_y_mm);
  Plane plane;
  plane.grid = {width, height, pixel_cycles * kCycle_rad};
  plane.sub = sub_pixels(field, plane.grid, kRange);
  plane.extent_y_mm = extent_y_mm;
  plane.begin_px = first_ring_px(field, plane.sub, kRange, 100);
  plane.bands = ray_bands(field, plane.grid, plane.sub, kRange, plane.begin_px,
                          [](double bandwidth) { return bandwidth / 3; });
  return plane;
}

const std::vector<Plane>& planes() {
  static const std::vector<Plane> all = {
      plane_of(64, 64, 0.4),   plane_of(65, 65, 1.2),   plane_of(1, 301, 0.7),
      plane_of(301, 1, 0.7),   plane_of(600, 40, 0.5),  plane_of(40, 601, 3.4),
      plane_of(400, 100, 12),  plane_of(2, 2, 30),      plane_of(90, 90, 1, 1.5),
      plane_of(2048, 2048, 5), plane_of(1000, 1, 0.05), plane_of(1, 1, 1)};
  return all;
}

TEST(SubPixels, WeightsSumToOneAndAreTheSameEitherWay) {
  for (const double pixel_cycles : {0.01, 0.3, 0.76, 1.0, 2.2, 7.0, 40.0}) {
    const SubPixels sub = plane_of(64, 64, pixel_cycles).sub;
    ASSERT_EQ(sub.weights.size(), 2u * sub.reach + 1);
    EXPECT_NEAR(std::accumulate(sub.weights.begin(), sub.weights.end(), 0.0), 1,
                3e-6);  // Single-precision weights of a sum rounded as often.
    for (int i = 0; i < sub.reach; ++i)
      EXPECT_NEAR(sub.weights[i], sub.weights[2 * sub.reach - i], 1e-6);
  }
}

TEST(SubPixels, PlacesDivideAPixelAndResolveTheDetail) {
  for (const double pixel_cycles : {0.01, 0.3, 0.76, 2.2, 40.0}) {
    const SubPixels sub = plane_of(64, 64, pixel_cycles).sub;
    EXPECT_DOUBLE_EQ(sub.pitch_rad * sub.per_pixel, pixel_cycles * kCycle_rad);
    EXPECT_LT(sub.pitch_rad, 0.5 * kCycle_rad);  // Else not even sampled.
    EXPECT_GE(2 * sub.reach, sub.per_pixel);
  }
}

TEST(RayBand, BandsCoverEveryPixelOnce) {
  for (const Plane& plane : planes()) {
    const int cx = plane.grid.center_x(), cy = plane.grid.center_y();
    Image<int> count(2 * cx + 1, 2 * cy + 1);  // About the axis, both halves of the plane.
    const auto add = [&](int x, int y) {
      ASSERT_LE(std::abs(x), cx);
      ASSERT_LE(std::abs(y), cy);
      ++count(cx + x, cy + y);
      ++count(cx - x, cy - y);
    };
    for (const RayBand& band : plane.bands)
      for (int major = band.begin_px; major < band.end_px; ++major) {
        // A diagonal is of both sectors, and counted with y_major.
        const int across =
            std::min(band.sector == Sector::y_major ? major : major - 1, band.across_px);
        for (int minor = -across; minor <= across; ++minor)
          band.sector == Sector::y_major ? add(minor, major) : add(major, minor);
      }
    for (int y = -cy; y <= cy; ++y)
      for (int x = -cx; x <= cx; ++x)
        ASSERT_EQ(count(cx + x, cy + y),
                  std::max(std::abs(x), std::abs(y)) >= plane.begin_px ? 1 : 0)
            << plane.grid.width << " x " << plane.grid.height << ": " << x << " " << y;
  }
}

TEST(RayBand, BandsFollowOneAnotherInwards) {
  for (const Plane& plane : planes())
    for (const Sector sector : {Sector::x_major, Sector::y_major}) {
      int end = 1 + (sector == Sector::x_major ? plane.grid.center_x() : plane.grid.center_y());
      for (const RayBand& band : plane.bands) {
        if (band.sector != sector) continue;
        EXPECT_EQ(band.end_px, end);
        EXPECT_LT(band.begin_px, band.end_px);
        end = band.begin_px;
      }
      if (end > plane.begin_px) ADD_FAILURE() << plane.grid.width << " x " << plane.grid.height;
    }
}

TEST(RayBand, RaysAndRowsReachAllPlacesOfItsPixels) {
  for (const Plane& plane : planes())
    for (const RayBand& band : plane.bands) {
      const double first = band.begin_px * plane.sub.per_pixel - plane.sub.reach;
      const double last = (band.end_px - 1) * plane.sub.per_pixel + plane.sub.reach;
      EXPECT_GT(band.first_rad, 0);
      EXPECT_NEAR(band.first_rad, first * plane.sub.pitch_rad, 1e-9 * band.first_rad);
      EXPECT_NEAR(band.last_rad, last * plane.sub.pitch_rad, 1e-9 * band.last_rad);
      // The widest angle is that of the innermost places.
      const double across =
          std::min(band.begin_px, band.across_px) * plane.sub.per_pixel + plane.sub.reach;
      EXPECT_GE(band.rays_each_side * band.ray_step, across / first);
    }
}

TEST(RayBand, StepsResolveTheDetail) {
  for (const Plane& plane : planes())
    for (const RayBand& band : plane.bands) {
      // From ray to ray at the outer edge, and from row to row, less than half a cycle.
      const double minor_mm = band.sector == Sector::x_major ? plane.extent_y_mm : kExtent_mm;
      EXPECT_GT(band.ray_step, 0);
      EXPECT_GT(band.fine_step, 0);
      EXPECT_GE(band.decimation, 1);
      EXPECT_LE(band.fine_step * band.last_rad, 0.5 * kCycle_rad);
      EXPECT_LT(band.ray_step * band.last_rad, 0.5 * 380e-6 / minor_mm);
    }
}

TEST(RayBand, RowsTimesRaysFitInMemory) {
  // Three channels, 16 million values held at a time, and some margin at the edges of each.
  for (const Plane& plane : planes())
    for (const RayBand& band : plane.bands) {
      const double rows =
          std::log(band.last_rad / band.first_rad) / (band.fine_step * band.decimation);
      const double rays = 2.0 * band.rays_each_side + 1;
      EXPECT_LT(3 * rows * rays, 1.25 * 16e6) << plane.grid.width << " " << band.begin_px;
    }
}

TEST(RayBand, NoBandsStepIsFinerThanTheFinest) {
  for (const Plane& plane : planes()) {
    const FarField field = field_of(plane.extent_y_mm);
    const double finest = finest_log_step(field, plane.grid, plane.sub, kRange);
    for (const RayBand& band : plane.bands)
      EXPECT_GE(band.fine_step, finest * (1 - 1e-9)) << plane.grid.width;
  }
}

}  // namespace
}  // namespace glare
