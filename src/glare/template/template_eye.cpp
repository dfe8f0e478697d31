#include "glare/template/template_eye.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glare/base/error.h"
#include "glare/base/units.h"
#include "glare/wavefront/wavefront_map.h"

namespace glare {

namespace {

constexpr double kCoarsest_mm = 0.008;

/// Half of the pixel with which an aperture reaches a field of view of that width, and back: with a
/// pixel of p it reaches lambda / p.
double half_pixel_for(double field_rad, const WavelengthRange& range) {
  return range.lo_nm * kMmPerNm / field_rad / 2;
}
double field_of_half_pixel_rad(double half_pixel_mm, const WavelengthRange& range) {
  return range.lo_nm * kMmPerNm / half_pixel_mm / 2;
}

/// Half of the pixel from which to the next the aberrations' phase moves by pi.
double half_pixel_for_phase(const EyeParameters& parameters, const TemplateOptions& options,
                            const WavelengthRange& range) {
  require_valid(options.aberrations);
  if (!options.aberrations.has_phase()) return kCoarsest_mm;
  const auto& center = options.aberrations.pupil_center;
  const double radius_mm = parameters.pupil_diameter_mm / 2 + std::hypot(center.x_mm, center.y_mm);
  const double slope_rad = steepest_slope_rad(options.aberrations, radius_mm, range);
  return range.lo_nm * kMmPerNm / std::max(slope_rad, 1e-6) / 4;
}

[[noreturn]] void throw_too_wide(double widest_rad, const PixelGrid& grid) {
  char text[160];
  std::snprintf(text, sizeof text,
                "the built-in eye is drawn for fields of view of at most %.3g degrees across this "
                "width",
                widest_rad / kRadPerDeg * grid.width / std::max(grid.width, grid.height));
  throw OptionError(text);
}

}  // namespace

ApertureSize template_eye_size(const EyeParameters& parameters, const TemplateOptions& options,
                               const WavelengthRange& range) {
  require_valid(parameters);
  const PixelGrid grid = pixel_grid(options);
  const double field_rad = grid.pitch_rad * std::max(grid.width, grid.height);
  const double pixel_mm = std::min({kCoarsest_mm, half_pixel_for(field_rad, range),
                                    half_pixel_for_phase(parameters, options, range)});
  const double finest_mm = finest_eye_pixel_mm(parameters);
  if (pixel_mm < finest_mm) throw_too_wide(field_of_half_pixel_rad(finest_mm, range), grid);

  const int width = static_cast<int>(std::ceil(eye_picture_width_mm(parameters) / pixel_mm));
  const ApertureSize size{width, width, pixel_mm};
  require_memory(size, options, range);
  return size;
}

Aperture draw_template_eye(const EyeParameters& parameters, const TemplateOptions& options,
                           const WavelengthRange& range) {
  return draw_eye(parameters, template_eye_size(parameters, options, range).pixel_mm,
                  options.threads, options.progress);
}

}  // namespace glare
