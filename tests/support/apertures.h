// Apertures of known shape for tests. Edges are anti-aliased: a sample is the mean transmittance
// over its pixel, exactly for upright rectangles, else over 16 x 16 points.
#pragma once

#include "glare/aperture/aperture.h"

namespace glare::test {

/// The picture to draw on. Its pixels are square, of side width_mm / width_px.
struct Frame {
  int width_px = 0;
  int height_px = 0;
  double width_mm = 0;

  double pixel_mm() const { return width_mm / width_px; }
  double height_mm() const { return pixel_mm() * height_px; }
};

/// A place on the picture, from its centre: right and down are positive.
struct Place {
  double x_mm = 0;
  double y_mm = 0;
};

/// An open disc.
Aperture circle(const Frame& frame, double diameter_mm, const Place& center = {});

/// An open upright rectangle.
Aperture rectangle(const Frame& frame, double width_mm, double height_mm, const Place& center = {});

/// An open upright square.
Aperture square(const Frame& frame, double side_mm, const Place& center = {});

/// A narrow upright opening, four fifths of the picture high: it spreads light to the sides.
Aperture slit(const Frame& frame, double width_mm);

/// Upright bars, open over half of each pitch, within the middle four fifths of the picture both
/// ways: spots to the sides at multiples of lambda / pitch.
Aperture grating(const Frame& frame, double pitch_mm);

/// An open disc with eight opaque eyelashes that reach into its upper half: each is slanted, and
/// tapers from a fiftieth of the disc's radius either side of its axis to a fifth of that.
Aperture lashed_pupil(const Frame& frame, double diameter_mm);

/// A letter F and a grey wedge that brightens to the right, off the centre: no symmetry at all,
/// so that a mirrored, turned or transposed pattern can't pass for the right one.
Aperture lopsided(const Frame& frame);

}  // namespace glare::test
