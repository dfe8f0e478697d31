// The glare of few bright points, each at its place between pixels.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "glare/convolution/glare_filter.h"
#include "glare/convolution/pixel_kernel.h"
#include "glare/picture/picture.h"
#include "glare/template/glare_template.h"

namespace glare {

/// A point of light in a picture.
struct PointSource {
  double x_px = 0, y_px = 0;     ///< A whole number is a pixel's centre.
  std::array<float, 3> light{};  ///< In the picture's channels: value times pixels.
};

/// The brightest pixels of a picture, as points at their centres, in the order of rows: as many of
/// them as hold `share` (0 to 1, else `OptionError`) of its light in each channel; none where that
/// takes more than `most`. A pixel is as bright as the sum of its shares of the channels' light;
/// channels that aren't finite or below 0 have none.
std::optional<std::vector<PointSource>> bright_points(const Picture& light, double share, int most);

/// The points whose glare stands for a whole picture's, to 0.1 % of the light that is added: at
/// most 300 pixels that hold 99.95 % of its light in each channel. None where it takes more, and
/// where light goes on beyond the border (`Edge::extend` and a border that isn't black).
std::optional<std::vector<PointSource>> few_points(const Picture& light, Edge edge);

struct PointGlareOptions {
  PixelKernelOptions kernel;
  double strength = 1;  ///< As in `ApplyGlareOptions`.
  /// False: the picture shows the points already, so that what is spread of their light is taken
  /// from where they are (from the four pixels around, by bilinear weights), as `apply_glare` does.
  /// True: it doesn't, and all their light is added.
  bool points_are_new = false;
  int threads = 0;
  ProgressCallback progress;
};

/// Adds the points' glare to a picture: each one's kernel, at its place between the pixels, by the
/// template's means over the pixels as they lie about it. For points at pixels' centres that is
/// what `apply_glare` makes of a picture of these points alone. Points may lie beyond the border.
/// Each place between pixels takes a kernel of its own, so that many points are quick only where
/// they lie alike. The options' shift is added to each place. The same bytes for any number of
/// threads. Throws as `pixel_kernel` does, `OptionError` for a point that isn't finite,
/// `Cancelled`; the picture is then as it was.
void add_point_glare(Picture& picture, std::span<const PointSource> points,
                     const GlareTemplate& glare_template, const PixelScale& scale,
                     const PointGlareOptions& options = {});

}  // namespace glare
