// A template as a display can show it.
#pragma once

#include <array>

#include "glare/base/image.h"
#include "glare/template/glare_template.h"

namespace glare {

struct PreviewOptions {
  /// Luminance, as a share of the brightest pixel's, that comes out at half of white.
  double middle_luminance = 1.2e-6;
  /// Decades of luminance that share the display's range: 1 is the contrast of the scene, larger
  /// numbers compress more (an exponent of 1 / compression before the sigmoid).
  double compression = 1.35;
};

/// The template tone-mapped to a display: R, G, B in [0, 1], encoded for sRGB (IEC 61966-2-1). The
/// luminance goes through a sigmoid, c^n / (c^n + 1) of c = L / middle with n = 1 / compression;
/// the colour is kept, and moved towards grey as far as the display's gamut asks for.
Image<std::array<float, 3>> preview(const GlareTemplate& glare_template,
                                    const PreviewOptions& options = {});

}  // namespace glare
