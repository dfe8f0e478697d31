#include "glare/template/template_eye.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <span>
#include <vector>

#include "glare/aperture/band_limit.h"
#include "glare/aperture/eye/eye_drawing.h"
#include "glare/base/error.h"
#include "glare/base/units.h"
#include "glare/wavefront/wavefront_map.h"

namespace glare {

namespace {

constexpr double kCoarsest_mm = 0.005;
constexpr int kWidest = 65536;
/// How much finer than the field needs: its rim is then at 0.385 cycles per pixel, within
/// `BandLimit::kPassed` with the far field's margin for interpolation.
constexpr double kFiner = 1.3;

/// The pixel with which the eye is sampled for a field of view of that width, and back: with a
/// pixel of p an aperture reaches lambda / p.
double pixel_for(double field_rad, const WavelengthRange& range) {
  return range.lo_nm * kMmPerNm / field_rad / kFiner;
}
double field_of_pixel_rad(double pixel_mm, const WavelengthRange& range) {
  return range.lo_nm * kMmPerNm / pixel_mm / kFiner;
}

/// Draws an eye's rows, and knows their mean squares: of a shape's edge, t^2 is t.
class FineEyeRows {
 public:
  FineEyeRows(const EyeDrawing& drawing, int columns)
      : drawing_(drawing), coverage_(columns), shapes_(columns) {}

  FineRow draw(const Grid& grid, int y, std::span<float> row) {
    const Columns open = drawing_.draw_shapes(grid, y, coverage_, row);
    std::copy(row.begin() + open.first, row.begin() + open.last, shapes_.begin() + open.first);
    drawing_.draw_lens(grid, y, open, row);
    double sum = 0;
    for (int x = open.first; x < open.last; ++x)
      if (shapes_[x] > 0) sum += row[x] * (row[x] / shapes_[x]);
    return {open, sum};
  }

 private:
  const EyeDrawing& drawing_;
  RowCoverage coverage_;
  std::vector<float> shapes_;
};

/// By how much aberrations widen the field: what is seen in a direction comes from frequencies of
/// the transmittance that are as far beyond it as the wavefront is steep.
double phase_field_rad(const EyeParameters& parameters, const TemplateOptions& options,
                       const WavelengthRange& range) {
  require_valid(options.aberrations);
  if (!options.aberrations.has_phase()) return 0;
  const auto& center = options.aberrations.pupil_center;
  const double radius_mm =
      eye_picture_width_mm(parameters) / 2 + std::hypot(center.x_mm, center.y_mm);
  return 2 * steepest_slope_rad(options.aberrations, radius_mm, range);
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
  const double pixel_mm = std::min(
      kCoarsest_mm, pixel_for(field_rad + phase_field_rad(parameters, options, range), range));
  const double width_mm = eye_picture_width_mm(parameters);
  const double finest_mm = width_mm / kWidest;
  if (pixel_mm < finest_mm) throw_too_wide(field_of_pixel_rad(finest_mm, range), grid);

  const int width = static_cast<int>(std::ceil(width_mm / pixel_mm));
  const ApertureSize size{width, width, width_mm / width};
  require_memory(size, options, range);
  return size;
}

Aperture draw_template_eye(const EyeParameters& parameters, const TemplateOptions& options,
                           const WavelengthRange& range) {
  const int size = template_eye_size(parameters, options, range).width;
  const EyeDrawing drawing(parameters);
  const auto rows = [&drawing, size]() -> FineRows {
    const auto drawer = std::make_shared<FineEyeRows>(drawing, BandLimit::kFineSamples * size);
    return [drawer](const Grid& grid, int y, std::span<float> row) {
      return drawer->draw(grid, y, row);
    };
  };
  return band_limited(size, drawing.width_mm(), rows, options.threads, options.progress);
}

}  // namespace glare
