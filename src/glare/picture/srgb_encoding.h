// sRGB's transfer curve for many values. Internal.
#pragma once

#include <span>

namespace glare {

/// Replaces each share of white in [0, 1] by what is sent to the display, `srgb_encoded` of
/// color/srgb.h, to 3e-6; at most 1.
void encode_srgb(std::span<float> values);

}  // namespace glare
