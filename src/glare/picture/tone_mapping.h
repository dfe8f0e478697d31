// Linear pictures brought to what a display shows: the sigmoid of Tumblin, Hodgins and Guenter, or
// exposure alone.
#pragma once

#include <array>

#include "glare/base/image.h"
#include "glare/picture/picture.h"

namespace glare {

/// How linear light becomes a display's values.
///
/// `tumblin_sigmoid` is the curve of J. Tumblin, J. K. Hodgins and B. K. Guenter, "Two methods for
/// display of high contrast images", ACM Transactions on Graphics 18(1), 1999, 56-94:
///
///     D (x^g + 1/k) / (x^g + k),   x = L / L_wa,
///
/// which runs from D / k^2 in the dark to D, and is D / k for light as bright as the adaptation,
/// L_wa. 255 is the display's white, so that D = 255 uses all of the display. (`SigmoidToneMap`,
/// which previews use, is the simpler curve of Naka and Rushton, x^n / (x^n + 1): black stays
/// black, and x = 1 is half of white.)
struct ToneMapping {
  enum class Curve {
    tumblin_sigmoid,
    linear,  ///< Exposure alone: 1 is white, and what is brighter is limited to it.
  };
  enum class Application {
    /// The curve of the luminance; the chromaticity is kept. A colour that the display can't show
    /// moves towards the grey of its luminance. Without any luminance it is grey.
    luminance,
    /// The curve of each of R, G and B (BT.709) by itself, with the same L_wa for all three: bright
    /// colours turn white, as in M. Kakimoto, K. Matsuoka, T. Nishita, T. Naemura and H. Harashima,
    /// "Glare generation based on wave optics", Computer Graphics Forum 24(2), 2005, 185-193. A
    /// colour with a negative channel first moves towards the grey of its luminance until none is.
    per_channel,
  };
  /// What becomes of the curve's result, as a share of white.
  enum class Transfer {
    srgb,  ///< It is the light that the display emits: encoded by sRGB's curve (IEC 61966-2-1).
    none,  ///< It is the display's value itself; so the paper uses D (a whole number to 255).
  };

  Curve curve = Curve::tumblin_sigmoid;
  Application application = Application::luminance;
  double adaptation_luminance = 1;  ///< L_wa, in the picture's unit; > 0. Not for `linear`.
  double gamma = 1;                 ///< g, the contrast around L_wa; 0.1 to 10. Not for `linear`.
  double k = 16;                    ///< Half the curve's range is at x^g = k; 1 to 1e4. As above.
  double display_maximum = 255;     ///< D, of 255; > 0 to 1e4. Above 255 limited to white.
  double exposure_stops = 0;        ///< Light is multiplied by 2^stops first; -100 to 100.
  Transfer transfer = Transfer::srgb;
};

/// R, G, B in [0, 1] for a display with the primaries and white of BT.709, as `encode_png_rgb8` and
/// `encode_png_rgb16` take them. The picture's colours are brought to these primaries first,
/// without adaptation of white. Values are within 5e-5 of the formula's. The same for any number of
/// `threads` (0: as many as the machine has). Pixels that aren't finite come out as some value in
/// [0, 1]. Throws `OptionError` for a setting outside its range.
Image<std::array<float, 3>> tone_mapped(const Picture& picture, const ToneMapping& mapping,
                                        int threads = 0);

}  // namespace glare
