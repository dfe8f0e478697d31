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
  explicit EyeDrawing(const EyeParameters& parameters);

  /// Of the picture, which is square.
  double width_mm() const { return width_mm_; }

  /// Sets all of `row`, which is row `y` of the picture; `coverage` is working memory of as many
  /// columns. Returns the columns outside which the row is 0.
  Columns draw_row(const Grid& grid, int y, RowCoverage& coverage, std::span<float> row) const;

 private:
  double width_mm_;
  Outline pupil_;
  std::vector<Outline> covers_;  ///< Lids and lashes.
  ParticleLayer particles_;
  LensLayer lens_;
};

}  // namespace glare
