// A template at another pitch.
#pragma once

#include "glare/base/image.h"
#include "glare/template/glare_template.h"

namespace glare {

/// The mean of a picture over the squares of another grid of `width` x `height` pixels, as if each
/// pixel's value filled its square, and 0 beyond the picture. `pitch_ratio` (above 0) is the new
/// pixels' pitch over the old ones'; the axis is the centre of pixel (width / 2, height / 2) of
/// both. Light is kept: the sum of the values times the pixels' area is the same, but for what
/// falls beyond the new borders.
Image<float> area_means(const Image<float>& picture, double pitch_ratio, int width, int height);

/// The template on a grid of `width` x `height` pixels (each at least 1) of `pitch_rad` (above 0),
/// each pixel being the template's mean over its square: energy is kept, but for what falls beyond
/// the new borders. Within an old pixel its light goes smoothly over into its neighbours', each
/// pixel's light being kept; see docs/conventions.md. It comes per steradian
/// (`Normalization::absolute`). Throws `OptionError` for a pitch or size out of range.
GlareTemplate resampled(const GlareTemplate& glare_template, double pitch_rad, int width,
                        int height);

/// The odd number of pixels of pitch `pitch_ratio` times the old one that covers `old_pixels` whose
/// axis is in the middle one (old_pixels / 2), where the axis is `shift_px` new pixels from the
/// centre of the middle new one.
int covering_size(int old_pixels, double pitch_ratio, double shift_px = 0);

}  // namespace glare
