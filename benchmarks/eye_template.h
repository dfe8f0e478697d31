// The template of which make_template's time is told.
#pragma once

#include "glare/template/make_template.h"

namespace glare::bench {

/// The built-in eye with a pupil such that its picture is 8 mm wide, `samples` a side.
Aperture eight_millimetre_eye(int samples);

/// As many pixels a side as the eye has samples, pixel = lambda / width at 380 nm: as far out as
/// the eye reaches. X, Y, Z per steradian; two threads.
TemplateOptions eye_template_options(int size);

}  // namespace glare::bench
