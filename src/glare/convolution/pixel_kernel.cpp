#include "glare/convolution/pixel_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glare/base/error.h"
#include "glare/base/range_check.h"
#include "glare/base/units.h"
#include "glare/convolution/kernel_source.h"
#include "glare/convolution/shifted_kernel.h"

namespace glare {

namespace {

void require_field_of_view(double fov_deg, int width_px) {
  if (!(fov_deg > 0 && fov_deg <= 180))
    throw OptionError("a field of view is above 0 and at most 180 degrees");
  require_in_range("a picture's width in pixels", width_px, 1, 1 << 30);
}

/// Throws `OptionError` for a pitch beyond 1.
PixelScale scale_of_pitch(double pitch_rad, double fov_deg) {
  if (pitch_rad > 0 && pitch_rad <= 1) return {pitch_rad, 1};
  char text[80];
  std::snprintf(text, sizeof text, "a field of view of %g degrees is too wide for so few pixels",
                fov_deg);
  throw OptionError(text);
}

void require_valid(const PixelKernelOptions& options) {
  require_in_range("the reach across in pixels", options.reach_x_px, 0, 1 << 30);
  require_in_range("the reach down in pixels", options.reach_y_px, 0, 1 << 30);
  require_in_range("the shift across in pixels", options.shift_x_px, -0.5, 0.5);
  require_in_range("the shift down in pixels", options.shift_y_px, -0.5, 0.5);
}

/// The pixels no farther from the middle one than the reach, where that isn't 0.
Image<float> within_reach(const Image<float>& kernel, int reach_x_px, int reach_y_px) {
  const auto half = [](int size, int reach) {
    return reach > 0 ? std::min(size / 2, reach) : size / 2;
  };
  const int half_x = half(kernel.width(), reach_x_px), half_y = half(kernel.height(), reach_y_px);
  Image<float> result(2 * half_x + 1, 2 * half_y + 1);
  for (int y = 0; y < result.height(); ++y)
    for (int x = 0; x < result.width(); ++x)
      result(x, y) = kernel(kernel.width() / 2 - half_x + x, kernel.height() / 2 - half_y + y);
  return result;
}

}  // namespace

PixelScale scale_of_field_of_view(double fov_deg, int width_px) {
  require_field_of_view(fov_deg, width_px);
  return scale_of_pitch(fov_deg * kRadPerDeg / width_px, fov_deg);
}

PixelScale scale_of_perspective(double fov_deg, int width_px) {
  require_field_of_view(fov_deg, width_px);
  return scale_of_pitch(2 * std::tan(fov_deg / 2 * kRadPerDeg) / width_px, fov_deg);
}

PixelKernel pixel_kernel(const GlareTemplate& t, const PixelScale& scale,
                         const RgbColorSpace& picture_space, const PixelKernelOptions& options) {
  require_valid(options);
  const KernelSource source(t, scale, picture_space, options);
  if (options.shift_x_px == 0 && options.shift_y_px == 0)
    return source.kernel(options.reach_x_px, options.reach_y_px, options.threads);
  const auto with_border = [](int reach_px) { return reach_px > 0 ? reach_px + 1 : 0; };
  PixelKernel result = shifted(source.kernel(with_border(options.reach_x_px),
                                             with_border(options.reach_y_px), options.threads),
                               options.shift_x_px, options.shift_y_px, options.threads);
  for (Image<float>& channel : result.channels)
    channel = within_reach(channel, options.reach_x_px, options.reach_y_px);
  return result;
}

}  // namespace glare
