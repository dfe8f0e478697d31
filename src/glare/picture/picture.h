// A colour picture in linear light.
#pragma once

#include <array>

#include "glare/base/image.h"
#include "glare/color/color_space.h"

namespace glare {

/// R, G, B of `color_space` (X, Y, Z for "xyz"), scene-linear and unclamped; three channels of one
/// size.
struct Picture {
  std::array<Image<float>, 3> channels;
  RgbColorSpace color_space = lin_rec709_color_space();

  int width() const { return channels[0].width(); }
  int height() const { return channels[0].height(); }
};

/// The luminance in the middle of all pixels', of those where it is positive and finite; 1 where
/// there are none. `channels` are those of a picture in `color_space`.
double median_luminance(const std::array<Image<float>, 3>& channels,
                        const RgbColorSpace& color_space);

}  // namespace glare
