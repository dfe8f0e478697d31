// The fibres of the eye's crystalline lens: a radial grating, whose first order is the lenticular
// halo, and the sutures where the fibres end.
#pragma once

namespace glare {

/// The lens's fibres and sutures, projected onto the pupil's plane.
///
/// Fibres run from the lens's equator towards its pole, so that they are a grating of radial lines.
/// Here it is made of rings: in each the number of fibres is constant and their pitch grows with
/// the radius by `fibre_pitch_variation`, around `fibre_pitch_um`. (One number of fibres for the
/// whole lens would make the pitch proportional to the radius, and of the halo a wide glow.) So the
/// first order is a ring at asin(wavelength / pitch), blue inside and red outside; a pupil smaller
/// than the zone's inner radius shows none.
///
/// The amplitude transmittance is sinusoidal, 1 - modulation (1 + cos) / 2: it has a first order
/// only, with modulation^2 / 8 of the light that enters the zone. The mean, 1 - modulation / 2, is
/// the same over the whole pupil, so that the zone has no edge; it drops out of a template. A real
/// lens's fibres change the phase rather; with the same light in the first order the halo is the
/// same.
struct LensParameters {
  /// Distance between neighbouring fibres, 5 to 30 um. 10.85 um puts the halo of 568 nm at 3
  /// degrees, as Spencer and others have it (1995, Physically-based glare effects, SIGGRAPH), after
  /// Simpson (1953, Br. J. Ophthalmol. 37, 449). Measured widths of fibres: 10.2 um in the
  /// periphery and 11.9 um in the centre (Brown, Bron and Sparrow 1987, Br. J. Ophthalmol. 71,
  /// 916).
  double fibre_pitch_um = 10.85;

  /// Full range of the pitch, relative to its mean: 0.02 to 0.5. It is the width of the halo's ring
  /// over its radius: 0.375 over 3 degrees in Spencer and others.
  double fibre_pitch_variation = 0.125;

  /// Where the zone of visible fibres begins, as radius on the pupil's plane, 0.5 to 5 mm. The halo
  /// is seen with pupils wider than 3 mm, and not with one of 1.9 mm (Spencer and others).
  double fibre_zone_inner_mm = 1.5;

  /// Where it ends, above the inner radius to 6 mm; 4.5 mm is the lens's equator, beyond any pupil.
  double fibre_zone_outer_mm = 4.5;

  /// Amplitude modulation of the grating, 0 to 1; 0 is no halo. A choice: 0.15 puts 0.2 % of the
  /// light of a 7 mm pupil into the halo, a faint ring about as bright as the corona beneath it.
  /// (Spencer and others put 3.3 % of a 4.9 mm pupil's there; about 0.5 does so.)
  double fibre_modulation = 0.15;

  /// Branches of the suture, 0 to 48; 0 is none. Y-shaped with 3 before birth, a star of 6 to 12
  /// later (Kuszak in Duane's Ophthalmology; 9 to 12 lines are visible).
  int suture_branches = 9;

  /// Length of a branch from the pole, above 0 to 5 mm; each is down to 70 % of it. A choice.
  double suture_length_mm = 2.5;

  /// Width of a branch, above 0 to 200 um: about a fibre's, 15.8 um beside a suture (Brown, Bron
  /// and Sparrow 1987).
  double suture_width_um = 16;

  /// Share of the amplitude that a branch takes, 0 to 1. A choice: faint streaks.
  double suture_contrast = 0.2;
};

/// Throws `OptionError` for a parameter outside its range.
void require_valid(const LensParameters& parameters);

}  // namespace glare
