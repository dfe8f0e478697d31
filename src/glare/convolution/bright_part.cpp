#include "glare/convolution/bright_part.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>

#include "glare/base/parallel.h"
#include "glare/base/range_check.h"
#include "glare/convolution/light_loops.h"

namespace glare {

namespace {

constexpr int kBandRows = 16;
constexpr double kLeastThreshold = 1e-30;  ///< Below is none, within a float's precision.

}  // namespace

BrightCurve bright_curve(const RgbColorSpace& color_space, const BrightPartOptions& options) {
  require_in_range("the exposure in stops", options.exposure_stops, -64, 64);
  require_in_range("the threshold", options.threshold, 0, 1e30);
  require_in_range("the threshold's knee", options.knee, 0, 1);
  BrightCurve curve;
  curve.exposure = static_cast<float>(std::exp2(options.exposure_stops));
  for (std::size_t k = 0; k < 3; ++k)
    curve.luminance_weights[k] = static_cast<float>(color_space.xyz_from_rgb()[1][k]);
  curve.all_light = options.threshold < kLeastThreshold;
  curve.start = static_cast<float>((1 - options.knee) * options.threshold);
  curve.step = static_cast<float>(2 * options.knee * options.threshold);
  curve.parabola = curve.step > 0 ? 1 / (2 * curve.step) : 0;
  return curve;
}

UnusablePixels bright_part(const Picture& picture, const BrightPartOptions& options,
                           Picture& bright, int threads) {
  const BrightCurve curve = bright_curve(picture.color_space, options);
  const int width = picture.width(), height = picture.height();
  for (auto& channel : bright.channels)
    if (channel.width() != width || channel.height() != height)
      channel = Image<float>::uninitialized(width, height);
  bright.color_space = picture.color_space;
  const auto stride = static_cast<std::size_t>(width);
  std::atomic<std::uint64_t> nan{0}, infinite{0}, negative{0};
  parallel_for((height + kBandRows - 1) / kBandRows, threads, [&](int band) {
    const int first = band * kBandRows, rows = std::min(kBandRows, height - first);
    ChannelLines<const float> pixels{{}, stride};
    ChannelLines<float> light{{}, stride};
    for (std::size_t k = 0; k < 3; ++k) {
      pixels.channels[k] = picture.channels[k].row(first).data();
      light.channels[k] = bright.channels[k].row(first).data();
    }
    const UnusablePixels some =
        take_light(curve, pixels, static_cast<std::size_t>(rows), stride, 1, light);
    nan += some.nan;
    infinite += some.infinite;
    negative += some.negative;
  });
  return {nan, infinite, negative};
}

}  // namespace glare
