// The loops over a picture's pixels, compiled for several instruction sets, of which the best that
// the machine has is taken when the program runs. Internal.
#pragma once

#include <array>
#include <cstddef>

#include "glare/color/color_space.h"
#include "glare/convolution/bright_part.h"

namespace glare {

/// Three channels of values, in lines that begin so many values after one another.
template <typename T>
struct ChannelLines {
  std::array<T*, 3> channels;
  std::size_t stride = 0;
};

/// What `bright_part` does, in the numbers that its loops take.
struct BrightCurve {
  float exposure = 1;
  std::array<float, 3> luminance_weights{};
  bool all_light = true;  ///< No threshold; the rest is not used then.
  float start = 0;        ///< Where the soft step begins,
  float step = 0;         ///< how wide it is,
  float parabola = 0;     ///< and 1 / (2 step), or 0.
};

/// Throws `OptionError` for options out of range.
BrightCurve bright_curve(const RgbColorSpace& color_space, const BrightPartOptions& options);

/// The light of `rows` lines of `columns` pixels, times `scale`. Returns which of them give none.
UnusablePixels take_light(const BrightCurve& curve, const ChannelLines<const float>& pixels,
                          std::size_t rows, std::size_t columns, float scale,
                          const ChannelLines<float>& light);

/// What is added to a picture.
struct GlareSum {
  float light_scale = 1;  ///< That `spread` was made with, a power of two.
  float strength = 1;
  bool only_glare = false;
  std::array<float, 3> own{};    ///< The share of a pixel's own light that is added to it.
  std::array<float, 3> least{};  ///< What `spread` is at least.
};

/// exposure * pixels + strength (spread + own * light) in their place, or the sum's second part
/// alone.
void add_glare(const BrightCurve& curve, const GlareSum& sum,
               const ChannelLines<const float>& spread, std::size_t rows, std::size_t columns,
               const ChannelLines<float>& pixels);

}  // namespace glare
