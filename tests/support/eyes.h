// Eyes with parts left out, for tests of what remains.
#pragma once

#include "glare/aperture/eye.h"

namespace glare {

/// Nothing inside the eye.
EyeParameters clear_eye();

/// And the lids out of the way, no lashes.
EyeParameters bare_pupil();

/// And a disc, in the middle.
EyeParameters round_pupil();

}  // namespace glare
