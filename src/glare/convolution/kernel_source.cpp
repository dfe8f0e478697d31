#include "glare/convolution/kernel_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "glare/base/error.h"
#include "glare/base/range_check.h"
#include "glare/template/resampled.h"

namespace glare {

namespace {

/// A lamp's channel under this share of its luminance is too dark to be divided by.
constexpr double kDarkestChannel = 0.05;
/// A lamp as near to the picture's white is that white: D65's table and its nominal chromaticity
/// differ by half of this, and so a template of D65 is on a picture's pixels what it is.
constexpr double kEqualWhites = 1e-3;
/// Pitches as near as this are equal: a file has one as a 32-bit float.
constexpr double kEqualPitches = 1.0 / (1 << 22);
/// Twice a picture's largest side, and 1: what `reach_x_px` and `reach_y_px` never cut.
constexpr double kLargestSide = 131071;

void require_valid(const PixelScale& scale) {
  if (!(scale.pitch_rad > 0 && scale.pitch_rad <= 1))
    throw OptionError("a pixel's pitch is above 0 and at most 1 in radians (57.3 degrees)");
  require_in_range("a pixel's aspect", scale.pixel_aspect, 1.0 / 64, 64);
}

bool is_positive(double value) { return value > 0 && std::isfinite(value); }

void require_light(const GlareTemplate& t) {
  const char* const place = "template";
  if (t.width() < 1 || t.height() < 1) throw InputError(place, "has no pixels");
  if (!is_positive(t.pixel_pitch_rad)) throw InputError(place, "has no pitch");
  if (!is_positive(t.per_steradian)) throw InputError(place, "has no scale");
  if (!is_positive(t.light_xyz[1]) || !std::isfinite(t.light_xyz[0] + t.light_xyz[2]))
    throw InputError(place, "has no light");
}

/// From the centre of the axis' pixel to the template's farther border, in a picture's pixels.
double farthest_border_px(int template_pixels, double pitch_ratio) {
  return (template_pixels / 2 + 0.5) / pitch_ratio;
}

/// Along one side: covers the template, but not beyond the reach.
GridAxis grid_axis(int template_pixels, double pitch_ratio, int reach_px) {
  const double farthest = farthest_border_px(template_pixels, pitch_ratio);
  const bool may_be_cut = reach_px > 0 && reach_px < farthest + 1;
  if (2 * (may_be_cut ? reach_px : farthest) > kLargestSide)
    throw OptionError("the template covers more than 131071 of the picture's pixels");
  int pixels = may_be_cut ? 2 * reach_px + 1 : std::numeric_limits<int>::max();
  if (farthest < kLargestSide)
    pixels = std::min(pixels, covering_size(template_pixels, pitch_ratio));
  return {pixels, pitch_ratio, 0};
}

/// A channel of the kernel: weights of the template's channels, which sum to `total` for all of its
/// light.
struct ChannelWeights {
  Vector3 of_template{};
  double total = 1;
};

/// The light's colour in the picture's channels, at luminance 1.
Vector3 light_in(const RgbColorSpace& picture_space, const Xyz& light_xyz) {
  const Vector3 light = picture_space.rgb_from_xyz() * light_xyz;
  const bool is_white = std::ranges::all_of(
      light, [&](double value) { return std::abs(value / light_xyz[1] - 1) < kEqualWhites; });
  if (!is_white) return light;
  return {light_xyz[1], light_xyz[1], light_xyz[1]};
}

/// From the template's channels to the picture's.
std::array<ChannelWeights, 3> channel_weights(const GlareTemplate& t,
                                              const RgbColorSpace& picture_space,
                                              const PixelKernelOptions& options) {
  const Matrix3& xyz_from_template = t.color_space.xyz_from_rgb();
  const Matrix3 picture_from_template = picture_space.rgb_from_xyz() * xyz_from_template;
  const Vector3 light = light_in(picture_space, t.light_xyz);
  const bool divided = options.lamp_color == PixelKernelOptions::LampColor::divided_out;
  std::array<ChannelWeights, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_dark = light[k] < kDarkestChannel * t.light_xyz[1];
    const bool as_luminance = options.luminance_only || (divided && is_dark);
    result[k].of_template = as_luminance ? xyz_from_template[1] : picture_from_template[k];
    const double all = as_luminance ? t.light_xyz[1] : light[k];
    const double unit = divided || as_luminance ? all : t.light_xyz[1];
    for (double& weight : result[k].of_template) weight /= unit;
    result[k].total = all / unit;
  }
  return result;
}

/// The template's light in one of the kernel's channels, by its own pixels, times `factor`.
Image<float> weighed(const GlareTemplate& t, const Vector3& weights, double factor) {
  Image<float> result = Image<float>::uninitialized(t.width(), t.height());
  const auto a = t.channels[0].values(), b = t.channels[1].values(), c = t.channels[2].values();
  const auto out = result.values();
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] =
        static_cast<float>(factor * (weights[0] * a[i] + weights[1] * b[i] + weights[2] * c[i]));
  return result;
}

Vector3 sums_of_channels(const GlareTemplate& t) {
  Vector3 sums{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (const float value : t.channels[k].values()) sums[k] += value;
    if (!std::isfinite(sums[k])) throw InputError("template", "has a pixel that isn't finite");
  }
  return sums;
}

}  // namespace

KernelSource::KernelSource(const GlareTemplate& t, const PixelScale& scale,
                           const RgbColorSpace& picture_space, const PixelKernelOptions& options) {
  require_valid(scale);
  require_light(t);
  double ratio = scale.pitch_rad / t.pixel_pitch_rad;
  if (std::abs(ratio - 1) < kEqualPitches) ratio = 1;
  pitch_ratios_ = {ratio, ratio / scale.pixel_aspect};
  const double per_template_pixel = t.per_steradian * t.pixel_pitch_rad * t.pixel_pitch_rad;
  const double per_pixel = t.per_steradian * scale.pitch_rad * scale.pitch_rad / scale.pixel_aspect;
  const Vector3 sums = sums_of_channels(t);
  const auto weights = channel_weights(t, picture_space, options);
  empty_.color_space = picture_space;
  empty_.scale = scale;
  template_size_ = {t.width(), t.height()};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3& w = weights[k].of_template;
    empty_.captured[k] = per_template_pixel * (w[0] * sums[0] + w[1] * sums[1] + w[2] * sums[2]);
    empty_.kept[k] = weights[k].total - empty_.captured[k];
    if (k == 0 || w != weights[k - 1].of_template) densities_[k] = weighed(t, w, per_pixel);
  }
}

PixelKernel KernelSource::kernel(int reach_x_px, int reach_y_px, int threads) const {
  const GridAxis across = grid_axis(template_size_[0], pitch_ratios_[0], reach_x_px);
  const GridAxis down = grid_axis(template_size_[1], pitch_ratios_[1], reach_y_px);
  PixelKernel result = empty_;
  for (std::size_t k = 0; k < 3; ++k)
    result.channels[k] = densities_[k].empty() ? result.channels[k - 1]
                                               : grid_means(densities_[k], across, down, threads);
  return result;
}

std::array<double, 2> KernelSource::farthest_px() const {
  std::array<double, 2> result{};
  for (std::size_t k = 0; k < 2; ++k)
    result[k] = std::min(farthest_border_px(template_size_[k], pitch_ratios_[k]) + 1, kLargestSide);
  return result;
}

}  // namespace glare
