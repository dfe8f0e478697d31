// The only source file that includes OpenImageIO. It sees only files whose structure is checked, in
// memory, and what it says of a picture is compared with the header: a decoder that finds another
// size than the one that was bounded does not get to write pixels.
#include "glare/io/image/decoder.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cctype>
#include <limits>
#include <memory>
#include <utility>

#include "glare/base/error.h"

namespace glare::image_io {

using std::uint16_t;
using std::uint64_t;
using std::uint8_t;

namespace {

void require_as_declared(const OIIO::ImageSpec& spec, const Header& header) {
  const bool same = spec.width > 0 && spec.height > 0 && spec.nchannels > 0 && spec.depth <= 1 &&
                    static_cast<uint64_t>(spec.width) == header.width &&
                    static_cast<uint64_t>(spec.height) == header.height &&
                    static_cast<uint64_t>(spec.nchannels) <= header.channels && !spec.deep;
  require(same, "the header is damaged");
}

Pixels pixels_for(const OIIO::ImageSpec& spec) {
  Pixels pixels;
  pixels.width = spec.width;
  pixels.height = spec.height;
  pixels.x = spec.x - spec.full_x;
  pixels.y = spec.y - spec.full_y;
  pixels.full_width = spec.full_width > 0 ? spec.full_width : spec.width;
  pixels.full_height = spec.full_height > 0 ? spec.full_height : spec.height;
  pixels.channels = spec.nchannels;
  pixels.names = spec.channelnames;
  const auto count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                     static_cast<std::size_t>(spec.nchannels);
  // A damaged file may leave pixels unread without a word; this value is refused later.
  pixels.values.assign(count, std::numeric_limits<float>::quiet_NaN());
  return pixels;
}

void turn_first_channel(Pixels& pixels) {
  const auto step = static_cast<std::size_t>(pixels.channels);
  for (std::size_t i = 0; i < pixels.values.size(); i += step) {
    pixels.values[i] = 1 - pixels.values[i];
  }
}

Bytes encoded_png(const OIIO::ImageSpec& spec, const void* pixels) {
  const auto output = OIIO::ImageOutput::create("png");
  if (!output) throw OutputError("PNG", one_line(OIIO::geterror()));
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  output->set_ioproxy(&memory);
  output->threads(1);
  const bool written = output->open("memory.png", spec) &&
                       output->write_image(spec.format, pixels) && output->close();
  if (!written) throw OutputError("PNG", one_line(output->geterror()));
  const auto bytes = std::as_bytes(std::span(encoded));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

Pixels decoded(const Format& format, const Header& header, Bytes& bytes) {
  const auto input = OIIO::ImageInput::create(format.reader);
  if (!input) throw BadImage("OpenImageIO has no reader for it: " + one_line(OIIO::geterror()));
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  input->set_ioproxy(&memory);
  input->threads(1);
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageSpec spec;
  if (!input->open(std::string("the file.") + format.reader, spec, as_stored)) {
    throw BadImage(one_line(input->geterror()));
  }
  require_as_declared(spec, header);
  Pixels pixels = pixels_for(spec);
  const bool read =
      input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.values.data());
  // A file that is cut short may give true, and only a message.
  const std::string message = input->geterror();
  input->close();
  if (!read || !message.empty()) throw BadImage(one_line(message));
  if (header.zero_is_white) turn_first_channel(pixels);
  return pixels;
}

Bytes encoded_png_rgb8(int width, int height, std::span<const uint8_t> samples) {
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  return encoded_png(spec, samples.data());
}

Bytes encoded_png_gray16(int width, int height, std::span<const uint16_t> samples) {
  return encoded_png(OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::UINT16), samples.data());
}

std::string one_line(std::string message) {
  while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back()))) {
    message.pop_back();
  }
  for (char& character : message) {
    if (std::iscntrl(static_cast<unsigned char>(character))) character = ' ';
  }
  return message.empty() ? "the data are damaged or cut short" : message;
}

}  // namespace glare::image_io
