// A template as a display can show it.
#pragma once

#include <array>

#include "glare/base/image.h"
#include "glare/color/tone_map.h"
#include "glare/template/glare_template.h"

namespace glare {

/// The tone map that previews use: the middle is a luminance as a share of the brightest pixel's.
inline constexpr SigmoidToneMap kPreviewToneMap{1.2e-6, 1.35};

/// The template tone-mapped to a display: R, G, B in [0, 1], encoded for sRGB.
Image<std::array<float, 3>> preview(const GlareTemplate& glare_template,
                                    const SigmoidToneMap& relative_tone_map = kPreviewToneMap);

}  // namespace glare
