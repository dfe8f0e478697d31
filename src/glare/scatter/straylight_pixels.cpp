#include "glare/scatter/straylight_pixels.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "glare/base/parallel.h"
#include "glare/base/units.h"
#include "glare/scatter/gauss_legendre.h"

namespace glare {

namespace {

double angle_deg(double sine) { return std::asin(sine) / kRadPerDeg; }

/// The means of S over the pixels of a row, from the axis' column on.
std::vector<double> half_row(const Straylight& eye, const PixelGrid& grid, int rows_from_axis) {
  // Where S begins to change.
  constexpr double kPlateau_rad = 0.075 * kRadPerDeg;
  const auto of_sine = [&](double sine) {
    return sine < 1 ? straylight_per_steradian(eye, angle_deg(sine)) : 0.0;
  };
  std::vector<double> means(static_cast<std::size_t>(grid.width / 2 + 1));
  for (std::size_t i = 0; i < means.size(); ++i)
    means[i] =
        mean_over_square(static_cast<double>(i) * grid.pitch_rad, rows_from_axis * grid.pitch_rad,
                         grid.pitch_rad, kPlateau_rad, of_sine);
  return means;
}

void add_to_row(const std::vector<double>& half_row, const PixelGrid& grid, int y, double kept,
                const Xyz& lamp_xyz, XyzImage& pixels) {
  for (std::size_t k = 0; k < pixels.size(); ++k) {
    const auto row = pixels[k].row(y);
    for (int x = 0; x < grid.width; ++x) {
      const double mean = half_row[static_cast<std::size_t>(std::abs(x - grid.center_x()))];
      float& pixel = row[static_cast<std::size_t>(x)];
      pixel = static_cast<float>(kept * pixel + lamp_xyz[k] * mean);
    }
  }
}

}  // namespace

double add_straylight(const Straylight& eye, const PixelGrid& grid, const Xyz& lamp_xyz,
                      int threads, const ProgressCallback& progress, XyzImage& pixels) {
  const double scattered = scattered_energy(eye);
  const auto add_both_rows = [&](int rows_from_axis) {
    const std::vector<double> means = half_row(eye, grid, rows_from_axis);
    const int above = grid.center_y() - rows_from_axis, below = grid.center_y() + rows_from_axis;
    if (above >= 0) add_to_row(means, grid, above, 1 - scattered, lamp_xyz, pixels);
    if (below != above && below < grid.height)
      add_to_row(means, grid, below, 1 - scattered, lamp_xyz, pixels);
  };
  parallel_for(grid.height / 2 + 1, threads, add_both_rows, progress);
  return scattered;
}

double cie_pixel_mean(const Straylight& eye, double x_rad, double y_rad, double pitch_rad) {
  const auto of_sine = [&](double sine) {
    return sine < 1 ? cie_general_glare(angle_deg(sine), eye.age_years, eye.pigment) : 0.0;
  };
  return mean_over_square(x_rad, y_rad, pitch_rad, std::numeric_limits<double>::min(), of_sine);
}

}  // namespace glare
