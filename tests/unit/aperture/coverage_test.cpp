#include "glare/aperture/coverage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace glare {
namespace {

using Shares = std::vector<std::vector<float>>;

Shares drawn(const Outline& outline, const Grid& grid) {
  Shares rows(grid.size, std::vector<float>(grid.size));
  RowCoverage coverage(grid.size);
  for (int y = 0; y < grid.size; ++y) {
    if (!outline.cover_row(grid, y, coverage)) continue;
    coverage.paint([&](int first, int last, float share) {
      for (int x = first; x < last; ++x) rows[y][x] = share;
    });
  }
  return rows;
}

std::vector<Point> circle(double radius, int vertices = 4096) {
  std::vector<Point> points;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / vertices;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

TEST(Coverage, OfARectangleIsItsShareOfEachSquare) {
  const Outline rectangle({{-1.25, -0.5}, {0.75, -0.5}, {0.75, 1.5}, {-1.25, 1.5}});
  EXPECT_DOUBLE_EQ(rectangle.area_mm2(), 4);
  const Shares expected = {
      {0, 0, 0, 0}, {0.125, 0.5, 0.375, 0}, {0.25, 1, 0.75, 0}, {0.125, 0.5, 0.375, 0}};
  EXPECT_EQ(drawn(rectangle, {4, 1}), expected);
}

TEST(Coverage, OfATriangleIsExact) {
  // Its long side is the diagonal from the top right corner to the bottom left one.
  const Outline triangle({{-1, -1}, {1, -1}, {-1, 1}});
  const Shares expected = {{1, 0.5}, {0.5, 0}};
  EXPECT_EQ(drawn(triangle, {2, 1}), expected);
}

TEST(Coverage, DoesNotDependOnTheDirectionOfTheOutline) {
  std::vector<Point> there = circle(1.3, 37), back(there.rbegin(), there.rend());
  const Shares a = drawn(Outline(there), {20, 0.15}), b = drawn(Outline(back), {20, 0.15});
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) EXPECT_NEAR(a[y][x], b[y][x], 1e-6);  // rounding to float
}

TEST(Coverage, AddsUpToTheArea) {
  for (const double pixel : {0.3, 0.07, 0.011}) {
    const Grid grid{static_cast<int>(3 / pixel), pixel};
    double sum = 0;
    for (const auto& row : drawn(Outline(circle(1.37)), grid))
      for (const float share : row) sum += share;
    // A polygon of 4096 corners has 4e-7 less area; rounding to float.
    EXPECT_NEAR(sum * pixel * pixel, std::numbers::pi * 1.37 * 1.37, 1e-5);
  }
}

TEST(Coverage, OutsideThePictureIsCutOff) {
  const Outline wide({{-10, -0.5}, {10, -0.5}, {10, 0.5}, {-10, 0.5}});
  const Shares expected = {{0, 0, 0, 0}, {0.5, 0.5, 0.5, 0.5}, {0.5, 0.5, 0.5, 0.5}, {0, 0, 0, 0}};
  EXPECT_EQ(drawn(wide, {4, 1}), expected);
}

}  // namespace
}  // namespace glare
