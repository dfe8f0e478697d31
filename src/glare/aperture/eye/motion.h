// How the built-in eye moves. Internal.
#pragma once

#include <cstdint>

#include "glare/aperture/eye.h"

namespace glare {

/// The pupil's diameter at a time: at time 0 that of the parameters. Its unrest is a sum of waves
/// of 0.05 to 2 Hz, equally strong for each octave up to 0.5 Hz and falling beyond, smoothly kept
/// within three times its root mean square.
double pupil_diameter_at_mm(const EyeParameters& parameters, double time_s);

/// The largest that it gets.
double largest_pupil_diameter_mm(const EyeParameters& parameters);

/// How far a blink has closed the lids, 0 (not at all) to 1. Each blink lasts 0.4 s: 0.1 s for
/// closing, which is the faster, 0.05 s closed and 0.25 s for opening. (After the lids' speed in
/// Doane, Am. J. Ophthalmol. 89, 1980, and the durations in VanderWerf and others, J. Neurophysiol.
/// 89, 2003.) There is one blink in each minute's part, at a time of its own.
double lid_closure_at(const EyeParameters& parameters, double time_s);

}  // namespace glare
