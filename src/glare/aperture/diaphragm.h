// A camera lens's diaphragm: the opening that an iris of blades leaves, with dust and scratches on
// the glass, drawn so that it can be had at any resolution.
#pragma once

#include <cstdint>

#include "glare/aperture/aperture.h"
#include "glare/base/progress.h"

namespace glare {

/// What the diaphragm looks like.
///
/// N blades make an opening of N corners and N edges. Each edge throws light across itself, to both
/// sides: an even N gives N streaks, as the streaks of opposite edges fall on one another, and an
/// odd N gives 2 N. The rounder the edges, the wider and weaker the streaks.
struct DiaphragmParameters {
  /// Diameter of the circle through the opening's corners, 0.1 to 200 mm. With a lens of focal
  /// length f stopped down to f/k it is about f / k.
  double diameter_mm = 5;

  /// Blades of the iris, 3 to 32.
  int blade_count = 6;

  /// How round the blades' edges are, 0 (straight) to 1 (the opening is a circle): each edge is an
  /// arc between two corners, of the radius diameter / (2 roundness).
  double roundness = 0;

  /// Turns the opening clockwise, -360 to 360 degrees; at 0 a corner points up.
  double rotation_deg = 0;

  /// Opaque specks of dust, 0 to 10000, spread evenly over the circle of that diameter, and their
  /// mean diameter, 0.001 to 5 mm; single ones have half to one and a half times that.
  int dust_count = 0;
  double dust_diameter_mm = 0.05;

  /// Opaque scratches, 0 to 1000, spread in the same way, in any direction, slightly bowed and
  /// pointed at both ends: their mean length, 0.01 to 200 mm (half to one and a half times that),
  /// and their width in the middle, 0.0001 to 1 mm.
  int scratch_count = 0;
  double scratch_length_mm = 2;
  double scratch_width_mm = 0.01;

  /// Picks the places and shapes of dust and scratches; any value. The same seed gives the same
  /// ones on every machine.
  std::uint64_t seed = 1;
};

/// Throws `OptionError` for a parameter outside its range.
void require_valid(const DiaphragmParameters& parameters);

/// The diaphragm's amplitude transmittance over a square 4 % wider than its diameter, whose centre
/// is the picture's. The pixel is the largest that is at most `max_pixel_mm` and divides the
/// square.
///
/// Drawn by area: a pixel is the share of its square that is inside the opening times, for each
/// speck and scratch, the share that is outside of that. The areas are exact for the straight edges
/// and within a millionth of a pixel for the curved ones, so there are no stair steps to diffract,
/// and averaging 2 x 2 pixels gives the picture at half the resolution (but where specks and
/// scratches cross one another or the opening's edge within a pixel).
///
/// Throws `OptionError` for a parameter outside its range, or a `max_pixel_mm` that is not
/// positive, is larger than a sixteenth of the diameter, or would need a picture wider than 65535
/// pixels.
///
/// `threads` is the number of threads (0: as many as the machine has); the picture is the same for
/// any. Throws `Cancelled` when the callback says stop.
Aperture draw_diaphragm(const DiaphragmParameters& parameters, double max_pixel_mm, int threads = 0,
                        const ProgressCallback& progress = {});

/// The width of the picture that `draw_diaphragm` makes.
double diaphragm_picture_width_mm(const DiaphragmParameters& parameters);

/// The area of the opening without dust and scratches, in mm^2: of the regular polygon, and of the
/// segments between its sides and the arcs.
double diaphragm_area_mm2(const DiaphragmParameters& parameters);

}  // namespace glare
