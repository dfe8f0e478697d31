// The built-in eye: a round pupil with the upper lid's eyelashes in front of it, drawn rather than
// photographed, so that it can be had at any resolution.
#pragma once

#include <cstdint>

#include "glare/aperture/aperture.h"
#include "glare/base/progress.h"

namespace glare {

/// What the built-in eye looks like. The lids are narrowed, as against a bright lamp at night: the
/// upper lid's margin lies just above the pupil and its lashes hang in front of the pupil.
struct EyeParameters {
  /// Diameter of the pupil, 1 to 10 mm. A dark-adapted young adult's is 5 to 8 mm.
  double pupil_diameter_mm = 6.5;

  /// Picks one eye's lashes among all; any value. The same seed is the same eye on every machine.
  std::uint64_t seed = 1;

  /// Eyelashes in front of the pupil, 0 to 1000; 0 is a bare pupil. An upper lid has 90 to 160, in
  /// 5 to 6 rows (Aumond and Bitton, J. Optometry 11, 2018), over about 30 mm: 20 to 40 over a wide
  /// pupil.
  int eyelash_count = 36;

  /// Width of the thickest lash at its root, above 0 to 0.5 mm; the others' is down to two thirds
  /// of it, and each tapers to a fifth at its tip. An adult's lashes are about 0.06 to 0.1 mm wide.
  double eyelash_root_width_mm = 0.1;

  /// How far down the tips reach: a share of the pupil's diameter from its top edge, 0 to 1; 0.5 is
  /// the pupil's middle. Most lashes end between 30 % earlier and 15 % later. Upper lashes are 8 to
  /// 12 mm long, but point towards the lamp, and are seen foreshortened.
  double eyelash_reach = 0.5;

  /// Angle between the straight-down direction and the outermost lashes, 0 to 60 degrees. Lashes
  /// spread out from the lid's curved margin; 35 is a choice, not a measurement.
  double eyelash_fan_deg = 35;
};

/// Throws `OptionError` for a parameter outside its range.
void require_valid(const EyeParameters& parameters);

/// The eye's amplitude transmittance over a square 4 % wider than the pupil, whose centre is the
/// picture's centre; up in the picture (row 0) is up in the eye. The pixel is the largest that is
/// at most `max_pixel_mm` and divides the square, which depends on the pupil's diameter alone.
///
/// Pupil and lashes are opaque-edged shapes drawn by area: a pixel is the share of its square that
/// is inside the pupil (exact) times, for each lash, the share that is outside it (exact for
/// straight edges). So there are no stair steps to diffract, and the same eye appears at every
/// resolution: averaging 2 x 2 pixels gives the picture at half the resolution.
///
/// Throws `OptionError` for a parameter outside its range, or a `max_pixel_mm` that is not
/// positive, is larger than a sixteenth of the pupil, or would need a picture wider than 65536
/// pixels.
///
/// `threads` is the number of threads (0: as many as the machine has); the picture is the same for
/// any. Throws `Cancelled` when the callback says stop.
Aperture draw_eye(const EyeParameters& parameters, double max_pixel_mm, int threads = 0,
                  const ProgressCallback& progress = {});

/// The width of the picture that `draw_eye` makes.
double eye_picture_width_mm(const EyeParameters& parameters);

/// The finest pixel that `draw_eye` draws: the picture is then 65536 pixels wide.
double finest_eye_pixel_mm(const EyeParameters& parameters);

}  // namespace glare
