// A template as a display can show it.
#pragma once

#include <array>

#include "glare/base/image.h"
#include "glare/color/tone_map.h"
#include "glare/template/glare_template.h"

namespace glare {

/// The tone map that previews use, of luminance as a multiple of the median pixel's: so a narrow
/// and a wide field both show their streaks. Chosen by eye.
inline constexpr SigmoidToneMap kPreviewToneMap{120, 1.25};

/// The template tone-mapped to a display: R, G, B in [0, 1], encoded for sRGB.
Image<std::array<float, 3>> preview(const GlareTemplate& glare_template,
                                    const SigmoidToneMap& relative_tone_map = kPreviewToneMap);

}  // namespace glare
