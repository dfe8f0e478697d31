// The glare of pictures of any size, after what the command line says.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "apply/apply_arguments.h"
#include "glare/convolution/glare_filter.h"
#include "glare/convolution/point_sources.h"

namespace glare::tool {

/// What the command reads, but for the pictures.
struct GlareInputs {
  GlareTemplate glare_template;
  std::optional<RgbColorSpace> color_space;  ///< Of the pictures, where the command line tells it.
  std::vector<PointSource> points;           ///< Of --sources FILE.
  std::string key;  ///< A fingerprint of these and of all options that the pictures depend on.
};

/// Throws `InputError`, `OptionError`, `MemoryError`.
GlareInputs read_glare_inputs(const ApplyArguments& arguments);

/// A picture's circumstances.
struct GlareWork {
  PixelScale scale;
  bool is_gray = false;
  std::uint64_t memory_bytes = 0;  ///< For the convolution.
  int threads = 0;
  ProgressCallback progress;
};

struct GlareOutcome {
  UnusablePixels unusable;
  std::optional<std::size_t> points;  ///< How many, where the glare is that of points.
};

class PictureGlare {
 public:
  /// Both outlive it.
  PictureGlare(const ApplyArguments& arguments, const GlareInputs& inputs)
      : arguments_(arguments), inputs_(inputs) {}

  /// The exposed picture with its glare, or the glare alone, in its place. May be called by several
  /// threads; the filter is kept for the next picture of the same kind. Throws as `apply_glare`
  /// does.
  GlareOutcome apply(Picture& picture, const GlareWork& work) const;

 private:
  /// All that a filter depends on.
  struct Kind {
    int width, height;
    double pitch_rad, pixel_aspect;
    bool is_gray;
    Matrix3 rgb_from_xyz;
    std::uint64_t memory_bytes;
    bool operator==(const Kind&) const = default;
  };
  struct Filter {
    Kind kind;
    GlareFilter filter;
  };
  PixelKernelOptions kernel_options(const Picture& picture, bool is_gray) const;
  PixelKernel kernel_for(const Picture& picture, const GlareWork& work) const;
  GlareFilter filter_for(const Picture& picture, const GlareWork& work) const;
  void add_points(Picture& picture, std::vector<PointSource> points, const GlareWork& work) const;
  std::optional<GlareOutcome> apply_by_points(Picture& picture, const GlareWork& work) const;

  const ApplyArguments& arguments_;
  const GlareInputs& inputs_;
  mutable std::mutex mutex_;
  mutable std::optional<Filter> filter_;  ///< The last one made.
};

}  // namespace glare::tool
