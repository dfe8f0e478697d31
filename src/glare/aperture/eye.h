// The built-in eye: pupil, lids, lashes and what is inside the eye, after anatomy; drawn rather
// than photographed, so that it can be had at any resolution and at any time.
#pragma once

#include <cstdint>

#include "glare/aperture/aperture.h"
#include "glare/aperture/eye/crystalline_lens.h"
#include "glare/aperture/eye/particles.h"
#include "glare/base/progress.h"

namespace glare {

/// The pupil as seen from outside. Its outline is an ellipse with the small irregularities of an
/// iris; whatever they are, its area is that of a disc of `diameter_mm`.
struct PupilParameters {
  /// 1 to 10 mm. See `pupil_diameter_mm` (pupil_diameter.h) for that of an adapted eye.
  double diameter_mm = 6.5;
  /// Shorter axis over the longer one, 0.5 to 1. Healthy pupils are within some percent of round
  /// (Wyatt, Vision Research 35, 1995).
  double axis_ratio = 0.97;
  /// Of the longer axis, -180 to 180, anticlockwise from the right as one looks at the picture.
  double longer_axis_deg = 80;
  /// Where the pupil's centre is, right and down of the eye's axis, -1 to 1. The pupil's centre is
  /// some tenths of a millimetre nasal of the cornea's, and moves as it dilates (Yang, Thompson and
  /// Burns, IOVS 43, 2002).
  double decentring_x_mm = 0.15, decentring_y_mm = -0.05;
  /// Root mean square departures of the outline from the ellipse, each from 0 to 3 % of the
  /// diameter: waves of 3 to 12 around the pupil, the scale of crypts and furrows, and of 20 to 80,
  /// that of the pigment ruff's folds. How large they are by default is a choice.
  double crypt_irregularity_mm = 0.02, ruff_irregularity_mm = 0.004;
};

/// The lids' margins: two parabolas (Malbouisson, Baccega and Cruz, Ophthal. Plast. Reconstr. Surg.
/// 16, 2000) that meet at the corners of the eye, 29 mm apart.
struct EyelidParameters {
  /// Between the margins in front of the eye's axis, 0.1 to 14 mm: 8 to 11 is wide open, 2 to 4
  /// squinting. The default is narrowed, as against a bright lamp at night: the upper margin is
  /// just above a wide pupil.
  double opening_mm = 7.6;
  /// Share of the opening that is above the axis, 0 to 1.
  double share_above = 0.47;
};

/// One lid's lashes. Each leaves the lid's margin towards the lamp, bends away from the pupil in an
/// arc, and is seen from the lamp, foreshortened.
struct EyelashParameters {
  /// On the whole lid, 0 to 1000. An upper lid has 90 to 160, in 5 to 6 rows, a lower one 75 to 80,
  /// in 3 to 4 (Aumond and Bitton, The eyelash follicle features and anomalies: a review, J.
  /// Optometry 11, 2018).
  int count = 120;
  /// Of the longest lashes, at the lid's middle, 0.1 to 20 mm: 8 to 12 mm on an upper lid, 6 to 8
  /// on a lower one (the same).
  double length_mm = 10;
  /// Width at the root, 1e-6 to 0.5 mm, of the thickest ones; and the tip's share of it, 0 to 1. An
  /// adult's lashes are some 0.06 to 0.1 mm wide. This taper, and the directions and the clumping
  /// below, are choices by eye: no measurements were found.
  double root_width_mm = 0.1, tip_share = 0.2;
  /// Angle between the line of sight and a lash at its root, -90 to 90: at 0 it points at the lamp,
  /// at 90 it lies across the pupil, and below 0 it leads away from it.
  double droop_deg = 45;
  /// How far an average lash turns away from the pupil from root to tip, 0 to 180.
  double curl_deg = 40;
  /// Angle to the vertical, as seen from the lamp, of the lashes at the corners, -90 to 90; towards
  /// the middle it falls to 0.
  double fan_deg = 60;
  /// Spread (root mean square) of a lash's direction around that of its place, 0 to 45.
  double scatter_deg = 9;
  /// How much the tips of neighbours are drawn together in tufts, 0 to 1.
  double clumping = 0.35;

  static EyelashParameters upper() { return {}; }
  static EyelashParameters lower();
};

/// What moves as time goes on. At time 0 the pupil has its own diameter and the lids are open.
struct MotionParameters {
  /// Root mean square of the change of the pupil's diameter (hippus), 0 to 10 % of it.
  double hippus_mm = 0.08;
  /// 0 to 40; 0 is an eye that doesn't blink. At rest some 17 (Bentivoglio and others, Movement
  /// Disorders 12, 1997).
  double blinks_per_minute = 15;
};

/// What the built-in eye looks like.
struct EyeParameters {
  PupilParameters pupil;
  EyelidParameters eyelids;
  EyelashParameters upper_lashes = EyelashParameters::upper();
  EyelashParameters lower_lashes = EyelashParameters::lower();
  ParticleParameters particles;
  LensParameters lens;
  MotionParameters motion;
  /// Picks one eye among all; any value. The same seed is the same eye on every machine.
  std::uint64_t seed = 1;
  /// When: 0 to 1e6 s. The eye is a continuous function of it.
  double time_s = 0;
};

/// Throws `OptionError` for a parameter outside its range.
void require_valid(const EyeParameters& parameters);

/// What of an eye is drawn; whole, it is the product of the other two, but where the edges of both
/// cross a pixel.
enum class EyeView {
  whole,
  pupil,     ///< The pupil and what is inside the eye: no lids, no lashes.
  eyelashes  ///< Lids and lashes, over all of the picture.
};

/// The eye's amplitude transmittance over a square around the eye's axis; up in the picture (row 0)
/// is up in the eye. The square holds the pupil at every time: its width doesn't depend on `time_s`
/// or `seed`. The pixel is the largest that is at most `max_pixel_mm` and divides the square.
///
/// Pupil, lids and lashes are sharp-edged shapes drawn by area: a pixel is the share of its square
/// that is inside the pupil (exact) times, for each lid and lash, the share that is outside it
/// (exact), and the mean transmittance of particles and lens. So there are no stair steps to
/// diffract, and the same eye appears at every resolution: averaging 2 x 2 pixels gives the picture
/// at half the resolution.
///
/// In the midst of a blink the picture is opaque, wholly or nearly: no template can be made of an
/// opaque one, which `require_valid(const Aperture&)` refuses; its veil is dark.
///
/// Throws `OptionError` for a parameter outside its range, or a `max_pixel_mm` that is not
/// positive, is larger than a sixteenth of the pupil, or would need a picture wider than 65536
/// pixels.
///
/// `threads` is the number of threads (0: as many as the machine has); the picture is the same for
/// any. Throws `Cancelled` when the callback says stop.
Aperture draw_eye(const EyeParameters& parameters, double max_pixel_mm, int threads = 0,
                  const ProgressCallback& progress = {}, EyeView view = EyeView::whole);

/// The width of the picture that `draw_eye` makes.
double eye_picture_width_mm(const EyeParameters& parameters);

/// The finest pixel that `draw_eye` draws: the picture is then 65536 pixels wide.
double finest_eye_pixel_mm(const EyeParameters& parameters);

}  // namespace glare
