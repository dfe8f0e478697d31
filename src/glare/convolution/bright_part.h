// The light of a picture that is spread: all of it, or what is above a threshold.
#pragma once

#include <cstdint>

#include "glare/picture/picture.h"

namespace glare {

struct BrightPartOptions {
  double exposure_stops = 0;  ///< The picture is multiplied by 2^exposure_stops first; -64 to 64.
  /// Luminance, in the unit of the exposed picture, from which on light is spread; 0: all of it.
  double threshold = 0;
  /// Half the width of the soft step at the threshold, as a share of it, 0 to 1: below
  /// (1 - knee) threshold nothing is spread, above (1 + knee) threshold all but the threshold,
  /// between a parabola that joins both smoothly.
  double knee = 0.5;
};

/// Pixels that give no light to the glare; each is counted once, as the first of these that it is.
struct UnusablePixels {
  std::uint64_t nan = 0;       ///< A channel is not a number.
  std::uint64_t infinite = 0;  ///< A channel is infinite.
  std::uint64_t negative = 0;  ///< A channel is below 0; its other channels are used.
  std::uint64_t total() const { return nan + infinite + negative; }
};

/// The light that is spread, of the exposed picture: a pixel's share of its luminance above the
/// threshold, in its own colour. A pixel with a channel that isn't finite gives none, nor does a
/// channel below 0. The exposed picture's luminance is that of its colour space. Throws
/// `OptionError` for options out of range.
UnusablePixels bright_part(const Picture& picture, const BrightPartOptions& options,
                           Picture& bright, int threads = 0);

}  // namespace glare
