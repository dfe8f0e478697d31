// Gauss-Legendre quadrature, and means over squares with it. Internal.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace glare {

/// A point of a quadrature over [-1, 1]; the weights sum to 1.
struct QuadraturePoint {
  double place, weight;
};
inline constexpr std::array<QuadraturePoint, 2> kGauss2 = {
    {{-0.5773502691896257, 0.5}, {0.5773502691896257, 0.5}}};
inline constexpr std::array<QuadraturePoint, 4> kGauss4 = {
    {{-0.8611363115940526, 0.1739274225687269},
     {-0.3399810435848563, 0.3260725774312731},
     {0.3399810435848563, 0.3260725774312731},
     {0.8611363115940526, 0.1739274225687269}}};

template <std::size_t kPoints, typename Function>
double gauss_mean(const std::array<QuadraturePoint, kPoints>& points, double x, double y,
                  double side, const Function& of_radius) {
  double sum = 0;
  for (const QuadraturePoint& v : points)
    for (const QuadraturePoint& u : points)
      sum += u.weight * v.weight *
             of_radius(std::hypot(x + side / 2 * u.place, y + side / 2 * v.place));
  return sum;
}

/// The mean of `of_radius(r)`, r from the origin, over the square of that side around (x, y), to
/// about 1e-6 for functions that change like a power -3 to 0 of r beyond `plateau`, and within it
/// on its scale. Squares near the origin are cut into smaller ones.
template <typename Function>
double mean_over_square(double x, double y, double side, double plateau,
                        const Function& of_radius) {
  const double nearest =
      std::hypot(std::max(0.0, std::abs(x) - side / 2), std::max(0.0, std::abs(y) - side / 2));
  const double scale = std::max(nearest, plateau);
  if (side <= scale / 1024) return of_radius(std::hypot(x, y));
  if (side <= scale / 16 && nearest > 2 * plateau)
    return gauss_mean(kGauss2, x, y, side, of_radius);
  if (side <= scale / 4) return gauss_mean(kGauss4, x, y, side, of_radius);
  double sum = 0;
  for (const double v : {-0.25, 0.25})
    for (const double u : {-0.25, 0.25})
      sum += mean_over_square(x + u * side, y + v * side, side / 2, plateau, of_radius);
  return sum / 4;
}

}  // namespace glare
