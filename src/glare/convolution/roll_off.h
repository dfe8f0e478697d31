// A kernel that fades out smoothly towards its border.
#pragma once

#include <array>

#include "glare/convolution/pixel_kernel.h"

namespace glare {

/// Where a kernel fades out.
struct RollOff {
  /// Of the ellipse on which, and beyond which, every share is exactly 0, in pixels from the axis;
  /// at least 1.
  int radius_x_px = 0, radius_y_px = 0;
  /// How much of the radius the fade takes, 0 to 1: with r the distance from the axis in radii,
  /// shares are as they were up to r = 1 - share, and times cos^2(pi/2 (r - 1 + share) / share)
  /// from there to r = 1, so that value and slope join at both ends.
  double share = 0.25;
};

/// Fades the kernel out in its place. The light taken from the outskirts goes to `kept`: it stays
/// in its own pixel, as the light beyond the template's field does. So a channel's light is 1 as
/// before, each share inside the fade is as it was (scaling them all would change every one), and
/// nothing is put where the template says that there is none. Returns what was taken, by channel:
/// no picture of values from 0 to 1 changes by more than that. Throws `OptionError` for a
/// radius below 1 or a share out of range.
std::array<double, 3> roll_off(PixelKernel& kernel, const RollOff& options);

}  // namespace glare
