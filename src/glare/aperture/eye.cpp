#include "glare/aperture/eye.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eyelashes.h"
#include "glare/base/error.h"
#include "glare/base/parallel.h"

namespace glare {

namespace {

constexpr double picture_per_pupil = 1.04;
constexpr int max_picture_width = 65536;

void require_in_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  char text[160];
  std::snprintf(text, sizeof text, "eye: %s is %g, expected %g to %g", name, value, low, high);
  throw OptionError(text);
}

/// Width of the picture in pixels.
int picture_width(double width_mm, double pupil_diameter_mm, double max_pixel_mm) {
  require_in_range("max_pixel_mm", max_pixel_mm, width_mm / max_picture_width,
                   pupil_diameter_mm / 16);
  // Slightly less than the quotient, so that a width_mm / n given as max_pixel_mm gives n pixels.
  return static_cast<int>(std::ceil(width_mm / max_pixel_mm * (1 - 1e-12)));
}

}  // namespace

void require_valid(const EyeParameters& p) {
  require_in_range("pupil diameter_mm", p.pupil.diameter_mm, 1, 10);
  require_in_range("lash count", p.upper_lashes.count, 0, 1000);
}

EyelashParameters EyelashParameters::lower() {
  EyelashParameters lashes;
  lashes.count = 75;
  lashes.length_mm = 7;
  lashes.droop_deg = -10;
  return lashes;
}

double eye_picture_width_mm(const EyeParameters& parameters) {
  return picture_per_pupil * parameters.pupil.diameter_mm;
}

double finest_eye_pixel_mm(const EyeParameters& parameters) {
  return eye_picture_width_mm(parameters) / max_picture_width;
}

Aperture draw_eye(const EyeParameters& parameters, double max_pixel_mm, int threads,
                  const ProgressCallback& progress) {
  require_valid(parameters);
  Aperture eye;
  eye.width_mm = eye_picture_width_mm(parameters);
  const int size = picture_width(eye.width_mm, parameters.pupil.diameter_mm, max_pixel_mm);
  eye.transmittance = Image<float>(size, size);

  const Grid grid{size, eye.width_mm / size};
  std::vector<Hair> hairs;
  for (const Eyelash& lash : eyelashes(parameters)) hairs.emplace_back(lash);
  constexpr int rows_per_task = 32;
  const auto draw_rows = [&](int task) {
    std::vector<float> covered(static_cast<std::size_t>(size));
    const int end = std::min(size, (task + 1) * rows_per_task);
    for (int y = task * rows_per_task; y < end; ++y) {
      const std::span<float> row = eye.transmittance.row(y);
      const Columns open = draw_pupil_row(grid, y, parameters.pupil.diameter_mm / 2, row);
      for (const Hair& hair : hairs) hair.draw_row(grid, y, open, covered, row);
    }
  };
  parallel_for((size + rows_per_task - 1) / rows_per_task, threads, draw_rows, progress);
  return eye;
}

}  // namespace glare
