// A kernel as a picture that other programs convolve with.
#pragma once

#include <array>

#include "glare/convolution/pixel_kernel.h"
#include "glare/picture/picture.h"

namespace glare {

struct KernelImageOptions {
  enum class Size {
    odd,          ///< Width and height odd, as the kernel's own.
    power_of_two  ///< Square, of 2^n pixels, of which the first row and column are 0 too.
  };
  enum class Alpha {
    none,
    luminance,  ///< The kernel of white light's luminance.
    impulse     ///< All in the centre: convolved with it, a picture's alpha stays.
  };
  Size size = Size::odd;
  Alpha alpha = Alpha::none;
  /// Width and height in pixels, 3 to 8192, odd or a power of two; 0: what holds all of the kernel
  /// (but for the outermost row and column, which are 0 in any case).
  int size_px = 0;
  double roll_off_share = 0.25;  ///< As in `RollOff`, of the radius that the picture has.
  /// For 16-bit floating point: values are rounded to it and sum to 4096 instead of 1, so that
  /// shares from 1.5e-8 on have all of its 11 bits and none is near its largest number.
  bool half = false;
  /// Turned by half a turn, for programs that multiply a pixel's neighbours by the values at the
  /// same places (correlation) instead of spreading a pixel's light by them (convolution).
  bool turned = false;
};

struct KernelImage {
  Picture picture;                 ///< In the kernel's colour space.
  Image<float> alpha;              ///< Empty for `Alpha::none`.
  std::array<int, 2> center_px{};  ///< Column and row of the axis: width / 2, height / 2.
  double sum = 1;                  ///< Of each channel: 1 or 4096.
  std::array<double, 3> taken{};   ///< Share of the light that the roll-off moved to the centre.
  /// No pixel of any channel is above the centre's: for programs that look for it.
  bool center_is_brightest = true;
};

/// The picture K of a kernel, for `result = K * picture`: the light that stays in its pixel,
/// `kept`, is in the centre's, so that it gives what `apply_glare` does without options, all but
/// for the roll-off. Every pixel of the border is 0, and all are finite. A channel's sum is as
/// told, within single precision's (half's) rounding of the centre: 6e-8 (2.5e-4) of it. Throws
/// `OptionError` for options out of range; `InputError` for a kernel that isn't finite.
KernelImage kernel_image(PixelKernel kernel, const KernelImageOptions& options = {});

}  // namespace glare
