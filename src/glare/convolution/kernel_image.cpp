#include "glare/convolution/kernel_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

#include "glare/base/error.h"
#include "glare/base/range_check.h"
#include "glare/convolution/roll_off.h"

namespace glare {

namespace {

using Options = KernelImageOptions;

constexpr int kLargestSize = 8192;
constexpr double kHalfSum = 4096;

/// Rounded to a half, whose steps are 2^-10 of its power of two and 2^-24 at least.
float rounded_to_half(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  const double step = std::ldexp(1., std::max(exponent - 11, -24));
  return static_cast<float>(std::nearbyint(value / step) * step);
}

std::array<int, 2> size_of(const PixelKernel& kernel, const Options& options) {
  if (options.size_px != 0) {
    require_in_range("a kernel picture's size", options.size_px, 3, kLargestSize);
    const bool is_power = std::has_single_bit(static_cast<unsigned>(options.size_px));
    if (options.size == Options::Size::power_of_two && !is_power)
      throw OptionError("a kernel picture's size is " + std::to_string(options.size_px) +
                        ", expected a power of two");
    if (options.size == Options::Size::odd && options.size_px % 2 == 0)
      throw OptionError("a kernel picture's size is " + std::to_string(options.size_px) +
                        ", expected an odd one, which has a pixel in its middle");
    return {options.size_px, options.size_px};
  }
  const std::array<int, 2> own = {std::max(kernel.width(), 3), std::max(kernel.height(), 3)};
  if (std::max(own[0], own[1]) > kLargestSize)
    throw OptionError("the kernel is " + std::to_string(own[0]) + " x " + std::to_string(own[1]) +
                      " pixels; expected a size up to " + std::to_string(kLargestSize));
  if (options.size == Options::Size::odd) return own;
  const unsigned least = static_cast<unsigned>(std::max(own[0], own[1]) - 1);
  const int size = std::max(4, static_cast<int>(std::bit_ceil(least)));
  return {size, size};
}

/// Half of the pixels beside the centre's, less those that are 0 at an even size.
int radius_in(int size) { return (size - 1) / 2; }

/// The kernel's pixels about the centre of a picture of this size, times `sum`.
Image<float> placed(const Image<float>& kernel, std::array<int, 2> size, double sum,
                    const Options& options) {
  Image<float> out(size[0], size[1]);
  const int sign = options.turned ? -1 : 1;
  for (int y = 0; y < kernel.height(); ++y)
    for (int x = 0; x < kernel.width(); ++x) {
      const int column = size[0] / 2 + sign * (x - kernel.width() / 2);
      const int row = size[1] / 2 + sign * (y - kernel.height() / 2);
      const float value = kernel(x, y);
      if (value == 0 || column < 0 || row < 0 || column >= size[0] || row >= size[1]) continue;
      out(column, row) =
          options.half ? rounded_to_half(value * sum) : static_cast<float>(value * sum);
    }
  return out;
}

/// What the other pixels leave of the sum goes to the centre.
void complete(Image<float>& image, double sum, const Options& options) {
  float& center = image(image.width() / 2, image.height() / 2);
  center = 0;
  double others = 0;
  for (const float value : image.values()) others += value;
  center = options.half ? rounded_to_half(sum - others) : static_cast<float>(sum - others);
}

bool center_leads(const Image<float>& image) {
  const float center = image(image.width() / 2, image.height() / 2);
  return std::ranges::none_of(image.values(), [&](float value) { return value > center; });
}

Image<float> alpha_of(const Picture& picture, double sum, const Options& options) {
  Image<float> alpha(picture.width(), picture.height());
  if (options.alpha == Options::Alpha::luminance) {
    const auto& weights = picture.color_space.xyz_from_rgb()[1];
    for (std::size_t i = 0; i < alpha.values().size(); ++i) {
      double y = 0;
      for (std::size_t k = 0; k < 3; ++k) y += weights[k] * picture.channels[k].values()[i];
      alpha.values()[i] = options.half ? rounded_to_half(y) : static_cast<float>(y);
    }
  }
  complete(alpha, sum, options);
  return alpha;
}

void require_finite(const PixelKernel& kernel) {
  for (const Image<float>& channel : kernel.channels)
    if (!std::ranges::all_of(channel.values(), [](float value) { return std::isfinite(value); }))
      throw InputError("kernel", "a share of the light isn't finite");
}

}  // namespace

KernelImage kernel_image(PixelKernel kernel, const Options& options) {
  require_finite(kernel);
  const std::array<int, 2> size = size_of(kernel, options);
  KernelImage image;
  image.taken = roll_off(kernel, {std::min(radius_in(size[0]), std::max(1, kernel.width() / 2)),
                                  std::min(radius_in(size[1]), std::max(1, kernel.height() / 2)),
                                  options.roll_off_share});
  image.sum = options.half ? kHalfSum : 1;
  image.center_px = {size[0] / 2, size[1] / 2};
  image.picture.color_space = kernel.color_space;
  for (std::size_t k = 0; k < 3; ++k) {
    image.picture.channels[k] = placed(kernel.channels[k], size, image.sum, options);
    complete(image.picture.channels[k], image.sum, options);
    image.center_is_brightest &= center_leads(image.picture.channels[k]);
  }
  if (options.alpha != Options::Alpha::none)
    image.alpha = alpha_of(image.picture, image.sum, options);
  return image;
}

}  // namespace glare
