// From the channels of a decoded picture to transmittances. Internal.
#pragma once

#include "glare/io/eye_photo.h"
#include "glare/io/image/decoder.h"
#include "glare/io/image_file.h"

namespace glare::image_io {

/// The transmittances that the pixels mean, as `read_transmittance` describes: of one channel, of
/// the luminance of three, or of an alpha that alone varies. `by_name`: channels go by their names,
/// not by their places. Throws `BadImage` for other channels, and for a value outside 0 to 1.001.
TransmittanceImage interpreted(const Pixels& pixels, bool by_name);

/// The same channels as a colour picture; of more than 1, it is divided by its largest value.
/// Throws `BadImage` for other channels, and for a value that is negative or not finite.
Photograph photograph_of(const Pixels& pixels, bool by_name);

}  // namespace glare::image_io
