// The parts of an eye at one time, drawn row by row at any resolution. Internal.
#pragma once

#include <span>
#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye.h"
#include "glare/aperture/eye/lens_layer.h"
#include "glare/aperture/eye/particle_layer.h"

namespace glare {

class EyeDrawing {
 public:
  /// Throws what `require_valid` throws.
  explicit EyeDrawing(const EyeParameters& parameters, EyeView view = EyeView::whole);

  /// Of the picture, which is square.
  double width_mm() const { return width_mm_; }

  /// Sets all of `row`, which is row `y` of the picture, to the share of each square that pupil,
  /// lids, lashes and particles leave open; `coverage` is working memory of as many columns.
  /// Returns the columns outside which the row is 0.
  Columns draw_shapes(const Grid& grid, int y, RowCoverage& coverage, std::span<float> row) const;

  /// Multiplies the row by the lens's transmittance, which is what completes it.
  void draw_lens(const Grid& grid, int y, Columns open, std::span<float> row) const {
    if (view_ != EyeView::eyelashes) lens_.draw_row(grid, y, open, row);
  }

 private:
  Columns draw_pupil(const Grid& grid, int y, RowCoverage& coverage, std::span<float> row) const;

  EyeView view_;
  double width_mm_;
  Outline pupil_;
  std::vector<Outline> covers_;  ///< Lids and lashes.
  ParticleLayer particles_;
  LensLayer lens_;
};

}  // namespace glare
