// The only source file that includes OpenImageIO. It sees only files whose structure is checked, in
// memory, and what it says of a picture is compared with the header: a decoder that finds another
// size than the one that was bounded does not get to write pixels.
#include "glare/io/module/image_codec.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace glare::module {

namespace {

/// What ends the work; its text is the message.
struct Refusal : std::runtime_error {
  explicit Refusal(const std::string& message, CodecOutcome why = CodecOutcome::refused)
      : std::runtime_error(message), outcome(why) {}
  CodecOutcome outcome;
};

template <typename Work>
CodecOutcome outcome_of(const Work& work, Message& message) noexcept try {
  work();
  return CodecOutcome::done;
} catch (const Refusal& refusal) {
  message.set(refusal.what());
  return refusal.outcome;
} catch (const std::bad_alloc&) {
  return CodecOutcome::no_memory;
} catch (const std::exception& error) {
  message.set(error.what());
  return CodecOutcome::failed;
} catch (...) {
  return CodecOutcome::failed;
}

// Decoding.

void require_as_declared(const OIIO::ImageSpec& spec, const ImageFile& file) {
  const bool same = spec.width > 0 && spec.height > 0 && spec.nchannels > 0 && spec.depth <= 1 &&
                    static_cast<std::uint64_t>(spec.width) == file.width &&
                    static_cast<std::uint64_t>(spec.height) == file.height &&
                    static_cast<std::uint64_t>(spec.nchannels) <= file.channels && !spec.deep;
  if (!same) throw Refusal("the header is damaged");
}

float* room_for(const OIIO::ImageSpec& spec, const PixelReceiver& receiver) {
  std::vector<const char*> names;
  for (const std::string& name : spec.channelnames) names.push_back(name.c_str());
  names.resize(static_cast<std::size_t>(spec.nchannels), "");
  const ImageLayout layout = {spec.width,
                              spec.height,
                              spec.x - spec.full_x,
                              spec.y - spec.full_y,
                              spec.full_width > 0 ? spec.full_width : spec.width,
                              spec.full_height > 0 ? spec.full_height : spec.height,
                              spec.nchannels,
                              names.data()};
  float* const room = receiver.room_for(receiver.context, layout);
  if (!room) throw std::bad_alloc();
  return room;
}

void decode_to(const ImageFile& file, const PixelReceiver& receiver) {
  const auto input = OIIO::ImageInput::create(file.reader);
  if (!input) throw Refusal(OIIO::geterror(), CodecOutcome::no_reader);
  OIIO::Filesystem::IOMemReader memory(file.bytes, file.size);
  input->set_ioproxy(&memory);
  input->threads(1);
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageSpec spec;
  if (!input->open(std::string("the file.") + file.reader, spec, as_stored))
    throw Refusal(input->geterror());
  require_as_declared(spec, file);
  const bool read =
      input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, room_for(spec, receiver));
  // A file that is cut short may give true, and only a message.
  const std::string message = input->geterror();
  input->close();
  if (!read || !message.empty()) throw Refusal(message);
}

CodecOutcome decode(const ImageFile& file, const PixelReceiver& receiver,
                    Message& message) noexcept {
  return outcome_of([&] { decode_to(file, receiver); }, message);
}

// Encoding.

void encode_png_to(const ImageSamples& image, const ByteReceiver& receiver) {
  const auto output = OIIO::ImageOutput::create("png");
  if (!output) throw Refusal(OIIO::geterror());
  OIIO::ImageSpec spec(image.width, image.height, image.channels,
                       image.bits == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8);
  if (image.tagged_srgb) spec.attribute("oiio:ColorSpace", "sRGB");
  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  output->set_ioproxy(&memory);
  output->threads(1);
  const bool written = output->open("memory.png", spec) &&
                       output->write_image(spec.format, image.samples) && output->close();
  if (!written) throw Refusal(output->geterror());
  if (!receiver.take(receiver.context, encoded.data(), encoded.size())) throw std::bad_alloc();
}

CodecOutcome encode_png(const ImageSamples& samples, const ByteReceiver& receiver,
                        Message& message) noexcept {
  return outcome_of([&] { encode_png_to(samples, receiver); }, message);
}

}  // namespace

}  // namespace glare::module

const glare::module::ImageCodec glare_image_codec = {GLARE_VERSION, glare::module::decode,
                                                     glare::module::encode_png};
