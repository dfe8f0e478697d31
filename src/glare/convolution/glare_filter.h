// A whole picture with the glare of all its pixels: convolution with a template's kernel.
#pragma once

#include <cstdint>
#include <memory>

#include "glare/base/progress.h"
#include "glare/convolution/bright_part.h"
#include "glare/convolution/pixel_kernel.h"
#include "glare/picture/picture.h"

namespace glare {

/// What lies beyond a picture's border.
enum class Edge {
  black,  ///< Nothing: light near the border is spread beyond it and lost.
  /// The border's own values go on: a picture of one value stays so up to its border. The kernel is
  /// then to be whole, not cut (`PixelKernelOptions::reach_x_px`): what lies beyond the picture's
  /// size in it counts.
  extend
};

struct GlareFilterOptions {
  Edge edge = Edge::black;
  int threads = 0;  ///< For its making; 0: as many as the machine has.
  /// What the filter and a call of `apply_glare` may take together, beside the picture; 0: no
  /// limit. Larger pictures are done in blocks, which give the same but for roundings. Every call
  /// that runs at the same time as another takes its own share.
  std::uint64_t memory_limit_bytes = 0;
};

/// A kernel made ready for pictures of one size. Made once, used for every frame, by several
/// threads at once; cheap to copy.
class GlareFilter {
 public:
  /// Throws `OptionError` for a size that isn't 1 to 65535 pixels, `MemoryError` where not even
  /// small blocks fit.
  GlareFilter(PixelKernel kernel, int width, int height, const GlareFilterOptions& options = {});

  int width() const;
  int height() const;
  const PixelKernel& kernel() const;

  struct Parts;
  const Parts& parts() const { return *parts_; }  ///< Internal.

 private:
  std::shared_ptr<const Parts> parts_;
};

struct ApplyGlareOptions {
  BrightPartOptions bright;
  double strength = 1;  ///< Of the change: 0 leaves the picture as it is; 0 to 1000.
  /// The result is what was added, with minus signs where light was taken from a pixel to be
  /// spread: picture (exposed) + result is the picture with its glare.
  bool only_glare = false;
  int threads = 0;
  ProgressCallback progress;
};

/// The picture with its glare, in its place, by Fourier transforms in single precision: errors are
/// some 3e-7 of the largest value that is added to a pixel anywhere (beside a light a million times
/// as bright as the rest, 1e-8 of it in the mean): with b the light that is spread (`bright_part`)
/// and K the kernel, picture + strength (b * K + (kept - 1) b), each channel with its own; nothing
/// wraps around the border. Light is only moved: the sum over a channel stays, but for what leaves
/// the picture. A pixel that isn't finite stays as it is. The picture's colour space is the
/// kernel's (not looked at). The same bytes for any number of threads. Returns which pixels gave no
/// light. Throws `OptionError` for a picture of another size or options out of range,
/// `MemoryError`, `Cancelled` (the picture is then half done).
UnusablePixels apply_glare(Picture& picture, const GlareFilter& filter,
                           const ApplyGlareOptions& options = {});

}  // namespace glare
