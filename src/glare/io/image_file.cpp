// The way of a picture from a file to transmittances: read to memory, recognize the format
// (format.h), check the structure and keep only what holds pixels (structure.h), compare sizes with
// the limits (image_header.h), decode (decoder.h), and take the channels for what they mean
// (transmittance.h). And back: values to samples, samples to PNG.
#include "glare/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/image/decoder.h"
#include "glare/io/image/format.h"
#include "glare/io/image/loading.h"
#include "glare/io/image/text_tags.h"
#include "glare/io/image/transmittance.h"

namespace glare {

using image_io::Bytes;
using image_io::Format;
using image_io::Pixels;
using std::uint16_t;
using std::uint64_t;
using std::uint8_t;

namespace {

TransmittanceImage transmittance_from(Bytes bytes, uint64_t max_bytes) {
  const Format& format = image_io::recognized_format(bytes);
  const auto width_mm = image_io::positive_tag(bytes, image_io::kWidthTag);
  const Pixels pixels = image_io::decoded_within(format, bytes, max_bytes, 1).pixels;
  TransmittanceImage image = image_io::interpreted(pixels, format.names_channels);
  image.width_mm = width_mm;
  return image;
}

Photograph photograph_from(Bytes bytes, uint64_t max_bytes) {
  const Format& format = image_io::recognized_format(bytes);
  const Pixels pixels = image_io::decoded_within(format, bytes, max_bytes, 3).pixels;
  return image_io::photograph_of(pixels, format.names_channels);
}

/// Thresholds of an 8 x 8 ordered dither: each of (2 i + 1) / 128 once, evenly spread.
float dither_threshold(int x, int y) {
  unsigned rank = 0;
  const auto column = static_cast<unsigned>(x), mixed = static_cast<unsigned>(x ^ y);
  for (unsigned bit = 0; bit < 3; ++bit) {
    rank = rank << 2 | (mixed >> bit & 1) << 1 | (column >> bit & 1);
  }
  return (static_cast<float>(rank) + 0.5f) / 64;
}

float limited(float value) { return value > 0 ? std::min(value, 1.0f) : 0.0f; }

uint16_t sample16_of(float value) {
  return static_cast<uint16_t>(std::lround(limited(value) * 65535));
}

}  // namespace

TransmittanceImage read_transmittance(const std::filesystem::path& path, uint64_t max_bytes) {
  return image_io::read_with(path, max_bytes, transmittance_from);
}

Photograph read_photograph(const std::filesystem::path& path, uint64_t max_bytes) {
  return image_io::read_with(path, max_bytes, photograph_from);
}

std::vector<std::byte> encode_png_rgb8(const Image<std::array<float, 3>>& display_rgb) {
  if (display_rgb.empty()) throw OutputError("PNG", "the picture has no pixels");
  std::vector<uint8_t> samples;
  samples.reserve(display_rgb.values().size() * 3);
  for (int y = 0; y < display_rgb.height(); ++y) {
    for (int x = 0; x < display_rgb.width(); ++x) {
      for (const float value : display_rgb(x, y)) {
        samples.push_back(static_cast<uint8_t>(limited(value) * 255 + dither_threshold(x, y)));
      }
    }
  }
  return image_io::encoded_png_rgb8(display_rgb.width(), display_rgb.height(), samples);
}

std::vector<std::byte> encode_png_rgb16(const Image<std::array<float, 3>>& display_rgb) {
  if (display_rgb.empty()) throw OutputError("PNG", "the picture has no pixels");
  std::vector<uint16_t> samples;
  samples.reserve(display_rgb.values().size() * 3);
  for (const auto& rgb : display_rgb.values())
    for (const float value : rgb) samples.push_back(sample16_of(value));
  return image_io::encoded_png_rgb16(display_rgb.width(), display_rgb.height(), samples);
}

std::vector<std::byte> encode_png_gray16(const Image<float>& values) {
  if (values.empty()) throw OutputError("PNG", "the picture has no pixels");
  std::vector<uint16_t> samples;
  samples.reserve(values.values().size());
  for (const float value : values.values()) samples.push_back(sample16_of(value));
  return image_io::encoded_png_gray16(values.width(), values.height(), samples);
}

std::vector<std::byte> encode_png_gray8(const Image<uint8_t>& values) {
  if (values.empty()) throw OutputError("PNG", "the picture has no pixels");
  return image_io::encoded_png_gray8(values.width(), values.height(), values.values());
}

}  // namespace glare
