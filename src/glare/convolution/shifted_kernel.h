// A kernel whose axis lies between the centres of pixels. Internal.
#pragma once

#include "glare/convolution/pixel_kernel.h"

namespace glare {

/// The kernel moved right and down by a part of a pixel, -0.5 to 0.5; it grows by a pixel on each
/// side that light is moved to. Light is kept, and its centre moves by the shift, to 0.01 pixel.
///
/// What goes smoothly from pixel to pixel moves as `grid_means` does it. What rises from the axis'
/// own pixel alone is narrower than a pixel, and where in it that lies isn't known: it is shared
/// out over the four pixels around by bilinear weights, as a picture itself shows a point.
PixelKernel shifted(const PixelKernel& kernel, double shift_x_px, double shift_y_px,
                    int threads = 0);

}  // namespace glare
