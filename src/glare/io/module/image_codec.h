// What the module glare_image_codec does, as the library sees it: C types, and nothing is thrown
// across. Internal.
#pragma once

#include <cstddef>
#include <cstdint>

#include "glare/io/module/message.h"

namespace glare::module {

enum class CodecOutcome : int {
  done,
  no_reader,  ///< There is none for the format.
  refused,    ///< The picture can't be decoded or isn't what its header says, or not encoded.
  no_memory,
  failed  ///< Anything else.
};

/// A file whose structure is checked, in memory, and what its header says.
struct ImageFile {
  const char* reader;  ///< OpenImageIO's name of the format.
  void* bytes;
  std::size_t size;
  std::uint64_t width, height;
  std::uint64_t channels;  ///< At most so many are decoded.
};

/// What is stored, and its place in the whole picture, perhaps a larger one.
struct ImageLayout {
  int width, height;
  int x, y;
  int full_width, full_height;
  int channels;
  const char* const* channel_names;
};

/// Gives the room for width x height x channels floats; null where there is no memory for them.
struct PixelReceiver {
  void* context;
  float* (*room_for)(void* context, const ImageLayout& layout) noexcept;
};

/// Samples of 8 or 16 bits, to be encoded.
struct ImageSamples {
  int width, height, channels, bits;
  bool tagged_srgb;
  const void* samples;
};

/// Takes what was encoded; false where there is no memory for it.
struct ByteReceiver {
  void* context;
  bool (*take)(void* context, const void* bytes, std::size_t size) noexcept;
};

/// `message` is OpenImageIO's own, perhaps empty and of several lines, unless all is done.
struct ImageCodec {
  const char* glare_version;  ///< First in every version, to be compared before anything is called.
  CodecOutcome (*decode)(const ImageFile& file, const PixelReceiver& receiver,
                         Message& message) noexcept;
  CodecOutcome (*encode_png)(const ImageSamples& samples, const ByteReceiver& receiver,
                             Message& message) noexcept;
};

}  // namespace glare::module

extern "C" __attribute__((visibility("default"))) const glare::module::ImageCodec glare_image_codec;
