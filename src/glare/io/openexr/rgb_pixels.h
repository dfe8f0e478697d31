// Three channels of colour and OpenEXR's scan lines. Internal.
#pragma once

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfPixelType.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "glare/base/image.h"
#include "glare/color/color_space.h"

namespace glare::openexr_io {

/// The names of a colour picture's channels: R, G, B or X, Y, Z.
std::array<const char*, 3> channel_names(const RgbColorSpace& space);

/// LAYER.CHANNEL; the channel's own name where the layer's is empty.
inline std::string name_in_layer(const std::string& layer, const std::string& channel) {
  return layer.empty() ? channel : layer + "." + channel;
}

/// A slice whose first pixel is the first of `pixels`.
template <typename T>
Imf::Slice slice_of(Imf::PixelType type, const Image<T>& pixels, const Imath::V2i& origin) {
  const auto x_stride = sizeof(T);
  const auto y_stride = sizeof(T) * static_cast<std::size_t>(pixels.width());
  auto* const first = reinterpret_cast<char*>(const_cast<T*>(pixels.values().data()));
  return Imf::Slice(type,
                    first - static_cast<std::ptrdiff_t>(x_stride) * origin.x -
                        static_cast<std::ptrdiff_t>(y_stride) * origin.y,
                    x_stride, y_stride);
}

/// The slices of three channels, by their names in `layer`.
template <typename T>
void insert_slices(Imf::FrameBuffer& frame_buffer, Imf::PixelType type, const RgbColorSpace& space,
                   const std::string& layer, const std::array<Image<T>, 3>& channels,
                   const Imath::V2i& origin) {
  const auto names = channel_names(space);
  for (std::size_t k = 0; k < names.size(); ++k)
    frame_buffer.insert(name_in_layer(layer, names[k]), slice_of(type, channels[k], origin));
}

template <typename T>
Imf::FrameBuffer frame_buffer_of(Imf::PixelType type, const RgbColorSpace& space,
                                 const std::array<Image<T>, 3>& channels,
                                 const Imath::V2i& origin) {
  Imf::FrameBuffer frame_buffer;
  insert_slices(frame_buffer, type, space, "", channels, origin);
  return frame_buffer;
}

/// False where half precision can't hold one of the values.
bool fits_half(const std::array<Image<float>, 3>& channels);

struct RgbFileOptions {
  bool half = false;
  int threads = 0;  ///< As in `TemplateFileOptions`.
  const std::function<bool()>& keep_going;
};

/// Three channels of one size; those of all a file's layers are of the same.
struct RgbLayer {
  std::string name;  ///< Empty: the channels have their own names only.
  const std::array<Image<float>, 3>* channels = nullptr;
  const Image<float>* alpha = nullptr;  ///< A channel A of the same size, if there is one.
};

/// A header of this size with ZIP compression, the channels and the space's chromaticities.
Imf::Header rgb_header(int width, int height, const RgbColorSpace& space, bool half);
/// The same with these layers.
Imf::Header rgb_header(int width, int height, const RgbColorSpace& space, bool half,
                       std::span<const RgbLayer> layers);

/// Writes a file with this header, of `rgb_header`, and these channels, all or nothing. Throws
/// `OutputError`, and `Cancelled` where `keep_going` says false.
void write_rgb_file(const std::filesystem::path& path, const Imf::Header& header,
                    const RgbColorSpace& space, const std::array<Image<float>, 3>& channels,
                    const RgbFileOptions& options);
/// The same with these layers.
void write_rgb_layers(const std::filesystem::path& path, const Imf::Header& header,
                      const RgbColorSpace& space, std::span<const RgbLayer> layers,
                      const RgbFileOptions& options);

}  // namespace glare::openexr_io
