// Drawing the crystalline lens's fibres and sutures. Internal.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "glare/aperture/coverage.h"
#include "glare/aperture/eye/crystalline_lens.h"
#include "glare/aperture/eye/small_shapes.h"

namespace glare {

/// The lens's fibres and sutures. They stay where they are: the lens doesn't move.
class LensLayer {
 public:
  /// Throws `OptionError` for parameters that `require_valid` refuses. The seed gives the fibres'
  /// phases and the sutures' directions and lengths.
  LensLayer(const LensParameters& parameters, std::uint64_t seed);

  /// Multiplies row `y` of the picture inside `open` by the lens's amplitude transmittance, a mean
  /// over each pixel's square. Several threads may draw at once.
  void draw_row(const Grid& grid, int y, Columns open, std::span<float> row) const;

 private:
  /// A ring in which the number of fibres is constant.
  struct Ring {
    double inner, outer;  // Radii.
    double fibres, phase;
  };
  /// A branch of the suture, from the pole outwards.
  class Suture : public Segment {
   public:
    Suture(Point end, double radius);
    /// The columns of row `y` that the branch may touch.
    Columns touched(const Grid& grid, int y) const;

   private:
    double slope_, half_width_;  // Both along x.
  };
  /// The row's columns `part`, which lie in `ring` and over which the phase is a cubic parabola.
  void draw_fibres(const Ring& ring, const Grid& grid, double y, Columns part,
                   std::span<float> row) const;
  void draw_fibre_row(const Grid& grid, int y, Columns open, std::span<float> row) const;
  void draw_sutures(const Grid& grid, int y, Columns open, std::span<float> row) const;

  LensParameters parameters_;
  std::vector<Ring> rings_;
  std::vector<Suture> sutures_;
};

}  // namespace glare
