#include "glare/aperture/eye.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye/eye_drawing.h"
#include "glare/aperture/eye/motion.h"
#include "glare/aperture/eye/pupil.h"
#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/base/range_check.h"

namespace glare {

namespace {

constexpr double picture_per_pupil = 1.04;
constexpr int max_picture_width = 65536;

void require_of_eye(const std::string& name, double value, double low, double high) {
  require_in_range("eye: " + name, value, low, high);
}

void require_valid(const PupilParameters& p) {
  constexpr double most_irregular = 0.03;  // Of the diameter.
  require_of_eye("pupil diameter_mm", p.diameter_mm, 1, 10);
  require_of_eye("pupil axis_ratio", p.axis_ratio, 0.5, 1);
  require_of_eye("pupil longer_axis_deg", p.longer_axis_deg, -180, 180);
  require_of_eye("pupil decentring_x_mm", p.decentring_x_mm, -1, 1);
  require_of_eye("pupil decentring_y_mm", p.decentring_y_mm, -1, 1);
  const double most_mm = most_irregular * p.diameter_mm;
  require_of_eye("pupil crypt_irregularity_mm", p.crypt_irregularity_mm, 0, most_mm);
  require_of_eye("pupil ruff_irregularity_mm", p.ruff_irregularity_mm, 0, most_mm);
}

void require_valid(const EyelidParameters& p) {
  require_of_eye("eyelid opening_mm", p.opening_mm, 0.1, 14);
  require_of_eye("eyelid share_above", p.share_above, 0, 1);
}

void require_valid(const EyelashParameters& p, const std::string& lid) {
  require_of_eye(lid + " lash count", p.count, 0, 1000);
  require_of_eye(lid + " lash length_mm", p.length_mm, 0.1, 20);
  require_of_eye(lid + " lash root_width_mm", p.root_width_mm, 1e-6, 0.5);
  require_of_eye(lid + " lash tip_share", p.tip_share, 0, 1);
  require_of_eye(lid + " lash droop_deg", p.droop_deg, -90, 90);
  require_of_eye(lid + " lash curl_deg", p.curl_deg, 0, 180);
  require_of_eye(lid + " lash fan_deg", p.fan_deg, -90, 90);
  require_of_eye(lid + " lash scatter_deg", p.scatter_deg, 0, 45);
  require_of_eye(lid + " lash clumping", p.clumping, 0, 1);
}

/// Width of the picture in pixels.
int picture_width(double width_mm, double pupil_diameter_mm, double max_pixel_mm) {
  require_of_eye("max_pixel_mm", max_pixel_mm, width_mm / max_picture_width,
                 pupil_diameter_mm / 16);
  // Slightly less than the quotient, so that a width_mm / n given as max_pixel_mm gives n pixels.
  return static_cast<int>(std::ceil(width_mm / max_pixel_mm * (1 - 1e-12)));
}

}  // namespace

EyelashParameters EyelashParameters::lower() {
  EyelashParameters lashes;
  lashes.count = 75;
  lashes.length_mm = 7;
  lashes.droop_deg = -10;
  return lashes;
}

void require_valid(const EyeParameters& p) {
  require_valid(p.pupil);
  require_valid(p.eyelids);
  require_valid(p.upper_lashes, "upper");
  require_valid(p.lower_lashes, "lower");
  require_valid(p.particles);
  require_valid(p.lens);
  constexpr double most_hippus = 0.1;  // Of the diameter.
  require_of_eye("motion hippus_mm", p.motion.hippus_mm, 0, most_hippus * p.pupil.diameter_mm);
  require_of_eye("motion blinks_per_minute", p.motion.blinks_per_minute, 0, 40);
  require_of_eye("time_s", p.time_s, 0, 1e6);
}

double eye_picture_width_mm(const EyeParameters& parameters) {
  return 2 * picture_per_pupil *
         pupil_reach_mm(parameters.pupil, largest_pupil_diameter_mm(parameters));
}

double finest_eye_pixel_mm(const EyeParameters& parameters) {
  return eye_picture_width_mm(parameters) / max_picture_width;
}

Aperture draw_eye(const EyeParameters& parameters, double max_pixel_mm, int threads,
                  const ProgressCallback& progress, EyeView view) {
  const EyeDrawing drawing(parameters, view);
  Aperture eye;
  eye.width_mm = drawing.width_mm();
  const int size = picture_width(eye.width_mm, parameters.pupil.diameter_mm, max_pixel_mm);
  eye.transmittance = Image<float>(size, size);

  const Grid grid{size, eye.width_mm / size};
  constexpr int rows_per_task = 32;
  const auto draw_rows = [&](int task) {
    RowCoverage coverage(size);
    const int end = std::min(size, (task + 1) * rows_per_task);
    for (int y = task * rows_per_task; y < end; ++y) {
      const auto row = eye.transmittance.row(y);
      drawing.draw_lens(grid, y, drawing.draw_shapes(grid, y, coverage, row), row);
    }
  };
  parallel_for((size + rows_per_task - 1) / rows_per_task, threads, draw_rows, progress);
  return eye;
}

}  // namespace glare
