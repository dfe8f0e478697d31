// Pictures as the module glare_image_codec decodes and encodes them, with its outcomes as
// exceptions.
#include "glare/io/image/decoder.h"

#include <cctype>
#include <limits>
#include <new>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/module/modules.h"

namespace glare::image_io {

using module::CodecOutcome;
using std::uint16_t;
using std::uint8_t;

namespace {

void set_layout(Pixels& pixels, const module::ImageLayout& layout) {
  pixels.width = layout.width;
  pixels.height = layout.height;
  pixels.x = layout.x;
  pixels.y = layout.y;
  pixels.full_width = layout.full_width;
  pixels.full_height = layout.full_height;
  pixels.channels = layout.channels;
  pixels.names.assign(layout.channel_names, layout.channel_names + layout.channels);
  const auto count = static_cast<std::size_t>(layout.width) *
                     static_cast<std::size_t>(layout.height) *
                     static_cast<std::size_t>(layout.channels);
  // A damaged file may leave pixels unread without a word; this value is refused later.
  pixels.values.assign(count, std::numeric_limits<float>::quiet_NaN());
}

float* room_for(void* pixels, const module::ImageLayout& layout) noexcept try {
  set_layout(*static_cast<Pixels*>(pixels), layout);
  return static_cast<Pixels*>(pixels)->values.data();
} catch (...) {
  return nullptr;
}

bool take_bytes(void* taken, const void* bytes, std::size_t size) noexcept try {
  const auto* const first = static_cast<const std::byte*>(bytes);
  static_cast<Bytes*>(taken)->assign(first, first + size);
  return true;
} catch (...) {
  return false;
}

void turn_first_channel(Pixels& pixels) {
  const auto step = static_cast<std::size_t>(pixels.channels);
  for (std::size_t i = 0; i < pixels.values.size(); i += step) {
    pixels.values[i] = 1 - pixels.values[i];
  }
}

/// Throws what both ways have in common.
void require_no_failure(CodecOutcome outcome, const module::Message& message) {
  if (outcome == CodecOutcome::no_memory) throw std::bad_alloc();
  if (outcome == CodecOutcome::failed) throw std::runtime_error(message.text);
}

Bytes encoded_png(const module::ImageSamples& samples) {
  Bytes bytes;
  module::Message message;
  const auto outcome = module::image_codec().encode_png(samples, {&bytes, take_bytes}, message);
  require_no_failure(outcome, message);
  if (outcome != CodecOutcome::done) throw OutputError("PNG", one_line(message.text));
  return bytes;
}

}  // namespace

Pixels decoded(const Format& format, const Header& header, Bytes& bytes) {
  const module::ImageFile file = {format.reader, bytes.data(),  bytes.size(),
                                  header.width,  header.height, header.channels};
  Pixels pixels;
  module::Message message;
  const auto outcome = module::image_codec().decode(file, {&pixels, room_for}, message);
  require_no_failure(outcome, message);
  if (outcome == CodecOutcome::no_reader)
    throw BadImage("OpenImageIO has no reader for it: " + one_line(message.text));
  if (outcome != CodecOutcome::done) throw BadImage(one_line(message.text));
  if (header.zero_is_white) turn_first_channel(pixels);
  return pixels;
}

Bytes encoded_png_rgb8(int width, int height, std::span<const uint8_t> samples) {
  return encoded_png({width, height, 3, 8, true, samples.data()});
}

Bytes encoded_png_rgb16(int width, int height, std::span<const uint16_t> samples) {
  return encoded_png({width, height, 3, 16, true, samples.data()});
}

Bytes encoded_png_gray16(int width, int height, std::span<const uint16_t> samples) {
  return encoded_png({width, height, 1, 16, false, samples.data()});
}

Bytes encoded_png_gray8(int width, int height, std::span<const uint8_t> samples) {
  return encoded_png({width, height, 1, 8, false, samples.data()});
}

std::string one_line(std::string message) {
  while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back()))) {
    message.pop_back();
  }
  for (char& character : message) {
    if (std::iscntrl(static_cast<unsigned char>(character))) character = ' ';
  }
  // OpenEXR's words for a file that it knows by the name of its stream.
  if (constexpr std::string_view kPrefix = "Cannot read image file \"file\". ";
      message.starts_with(kPrefix))
    message.erase(0, kPrefix.size());
  return message.empty() ? "the data are damaged or cut short" : message;
}

}  // namespace glare::image_io
