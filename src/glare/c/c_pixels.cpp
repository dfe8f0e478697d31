#include "glare/c/c_pixels.h"

#include <cstdlib>
#include <limits>
#include <string>

#include "glare/c/c_errors.h"

namespace glare::c {

namespace {

constexpr std::int32_t kMostPixels = 65535;

/// The lowest and the highest place that a buffer's values have, from the first one.
struct Extent {
  std::ptrdiff_t low = 0, high = 0;

  /// `count` of what there is, `stride` apart. Throws `OptionError` where a place has no number.
  void repeat(std::int32_t count, std::ptrdiff_t stride, const char* name) {
    if (count > 1 && stride == 0) throw OptionError(std::string(name) + " is 0");
    std::ptrdiff_t last = 0;
    std::ptrdiff_t& end = stride < 0 ? low : high;
    if (__builtin_mul_overflow(static_cast<std::ptrdiff_t>(count - 1), stride, &last) ||
        __builtin_add_overflow(end, last, &end))
      throw OptionError(std::string(name) + " is too large");
  }
};

void require_sizes(const glare_pixels& p) {
  if (p.width < 1 || p.height < 1 || p.width > kMostPixels || p.height > kMostPixels)
    throw OptionError("a picture of " + std::to_string(p.width) + " x " + std::to_string(p.height) +
                      " pixels: expected 1 to 65535 each way");
  if (p.channels != 1 && p.channels != 3)
    throw OptionError("a picture of " + std::to_string(p.channels) +
                      " channels: expected 1 (grey) or 3");
}

/// The distance between channel 0 and the channel of the picture that channel `k` is.
std::ptrdiff_t channel_offset(const glare_pixels& p, std::size_t k) {
  return p.channels == 1 ? 0 : static_cast<std::ptrdiff_t>(k) * p.channel_stride;
}

/// Where a row begins.
float* row_of(const glare_pixels& p, std::size_t k, int y) {
  return p.buffer +
         (static_cast<std::ptrdiff_t>(p.first) + y * p.row_stride + channel_offset(p, k));
}

void describe(glare_pixels* pixels, const glare_pixels& described) {
  require(pixels, "pixels");
  require_valid(described);
  *pixels = described;
}

}  // namespace

void require_valid(const glare_pixels& p) {
  require(p.buffer, "the picture's buffer");
  require_sizes(p);
  Extent extent;
  extent.repeat(p.width, p.pixel_stride, "pixel_stride");
  extent.repeat(p.height, p.row_stride, "row_stride");
  extent.repeat(p.channels, p.channel_stride, "channel_stride");
  constexpr auto kMostFloats =
      static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max()) / sizeof(float);
  std::ptrdiff_t low = 0, high = 0;
  if (p.buffer_floats > kMostFloats || p.first >= p.buffer_floats ||
      __builtin_add_overflow(static_cast<std::ptrdiff_t>(p.first), extent.low, &low) ||
      __builtin_add_overflow(static_cast<std::ptrdiff_t>(p.first), extent.high, &high) || low < 0 ||
      high >= static_cast<std::ptrdiff_t>(p.buffer_floats))
    throw OptionError("a picture of " + std::to_string(p.width) + " x " + std::to_string(p.height) +
                      " pixels doesn't fit in its buffer of " + std::to_string(p.buffer_floats) +
                      " floats");
}

std::array<Image<float>, 3> channels_from(const glare_pixels& p) {
  std::array<Image<float>, 3> channels;
  for (std::size_t k = 0; k < 3; ++k) {
    channels[k] = Image<float>::uninitialized(p.width, p.height);
    for (int y = 0; y < p.height; ++y) {
      const float* const from = row_of(p, k, y);
      for (int x = 0; x < p.width; ++x) channels[k](x, y) = from[x * p.pixel_stride];
    }
  }
  return channels;
}

void copy_channels(const std::array<Image<float>, 3>& channels, const glare_pixels& p) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.channels); ++k)
    for (int y = 0; y < p.height; ++y) {
      float* const to = row_of(p, k, y);
      for (int x = 0; x < p.width; ++x) to[x * p.pixel_stride] = channels[k](x, y);
    }
}

}  // namespace glare::c

using namespace glare::c;

glare_status glare_pixels_interleaved(glare_pixels* pixels, float* buffer, size_t buffer_floats,
                                      int32_t width, int32_t height, int32_t floats_per_pixel,
                                      glare_error* error) {
  return guarded(error, [&] {
    if (floats_per_pixel != 1 && floats_per_pixel < 3)
      throw glare::OptionError("a pixel of " + std::to_string(floats_per_pixel) +
                               " floats: expected 1 (grey), or 3 or more");
    const ptrdiff_t row = static_cast<ptrdiff_t>(floats_per_pixel) * width;
    describe(pixels, {buffer, buffer_floats, 0, width, height, floats_per_pixel == 1 ? 1 : 3,
                      floats_per_pixel, row, 1});
  });
}

glare_status glare_pixels_planar(glare_pixels* pixels, float* buffer, size_t buffer_floats,
                                 int32_t width, int32_t height, int32_t channels,
                                 glare_error* error) {
  return guarded(error, [&] {
    const ptrdiff_t plane = static_cast<ptrdiff_t>(width) * height;
    describe(pixels, {buffer, buffer_floats, 0, width, height, channels, 1, width, plane});
  });
}
