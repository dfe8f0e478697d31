// Where an aperture lets light through. Internal.
#pragma once

#include "glare/aperture/aperture.h"

namespace glare {

/// A rectangle of samples.
struct OpenPart {
  int x0 = 0, y0 = 0, width = 0, height = 0;
};

/// The smallest rectangle outside which the transmittance is 0; of no size where it is 0
/// throughout.
OpenPart open_part(const Aperture& aperture);

}  // namespace glare
