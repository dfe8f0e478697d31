// A template in a picture's channels, from which kernels for different places are made. Internal.
#pragma once

#include <array>

#include "glare/convolution/pixel_kernel.h"
#include "glare/template/grid_means.h"

namespace glare {

/// What the kernels of one template and scale share.
class KernelSource {
 public:
  /// Throws as `pixel_kernel` does, but for options of reach and shift, which it doesn't look at.
  KernelSource(const GlareTemplate& glare_template, const PixelScale& scale,
               const RgbColorSpace& picture_space, const PixelKernelOptions& options);

  /// The reach is as in `PixelKernelOptions`.
  PixelKernel kernel(int reach_x_px, int reach_y_px, int threads = 0) const;

  const std::array<double, 3>& kept() const { return empty_.kept; }

  /// No kernel reaches farther across or down, in pixels.
  std::array<double, 2> farthest_px() const;

 private:
  std::array<int, 2> template_size_{};
  std::array<double, 2> pitch_ratios_{};  ///< Across and down, the picture's over the template's.
  /// The template's pixels as shares for a picture's pixel; one that is empty is as that before.
  std::array<Image<float>, 3> densities_;
  PixelKernel empty_;  ///< All but the channels.
};

}  // namespace glare
