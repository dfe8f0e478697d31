// A template as a display can show it.
#pragma once

#include <array>

#include "glare/base/image.h"
#include "glare/color/tone_map.h"
#include "glare/template/glare_template.h"

namespace glare {

/// The tone map that previews use, of luminance per steradian, so that the same light looks the
/// same whatever the field and the pixels are: the middle is what a wide pupil's light has at about
/// 0.8 degrees, and the compression shows some five decades. Chosen by eye.
inline constexpr SigmoidToneMap kPreviewToneMap{30, 1.35};

/// The template tone-mapped to a display: R, G, B in [0, 1], encoded for sRGB.
Image<std::array<float, 3>> preview(const GlareTemplate& glare_template,
                                    const SigmoidToneMap& tone_map_per_steradian = kPreviewToneMap);

}  // namespace glare
