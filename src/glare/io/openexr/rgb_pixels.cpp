#include "glare/io/openexr/rgb_pixels.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "glare/base/error.h"
#include "glare/io/openexr/file_output.h"
#include "glare/io/openexr/memory_stream.h"
#include "glare/io/template_file.h"

namespace glare::openexr_io {

namespace {

constexpr int kBandRows = 256;  // Whole blocks of ZIP, 16 rows each.

using Channels = std::array<Image<float>, 3>;

Imath::V2f vector_of(const Chromaticity& c) {
  return {static_cast<float>(c.x), static_cast<float>(c.y)};
}

Imf::Chromaticities chromaticities_of(const RgbColorSpace& space) {
  const auto primaries = space.primaries();
  return {vector_of(primaries[0]), vector_of(primaries[1]), vector_of(primaries[2]),
          vector_of(chromaticity(space.white_xyz()))};
}

/// Gives OpenEXR the pixels band by band.
class PixelWriter {
 public:
  PixelWriter(Imf::OutputFile& file, const RgbColorSpace& space, std::span<const RgbLayer> layers,
              bool as_half)
      : file_(file), space_(space), layers_(layers), as_half_(as_half) {
    if (as_half_) {
      std::array<Image<Imath::half>, 3> band;
      band.fill(Image<Imath::half>(first_channel().width(), std::min(height(), kBandRows)));
      halves_.assign(layers.size(), band);
      half_alphas_.assign(layers.size(), band[0]);
      return;
    }
    Imf::FrameBuffer frame_buffer;
    for (const RgbLayer& layer : layers) {
      insert_slices(frame_buffer, Imf::FLOAT, space, layer.name, *layer.channels, {0, 0});
      if (layer.alpha)
        frame_buffer.insert(name_in_layer(layer.name, "A"),
                            slice_of(Imf::FLOAT, *layer.alpha, {0, 0}));
    }
    file_.setFrameBuffer(frame_buffer);
  }

  int height() const { return first_channel().height(); }

  void write(int first_row, int rows) {
    if (as_half_) convert(first_row, rows);
    file_.writePixels(rows);
  }

 private:
  const Image<float>& first_channel() const { return (*layers_[0].channels)[0]; }

  static void convert(const Image<float>& values, int first_row, int rows,
                      Image<Imath::half>& halves) {
    for (int row = 0; row < rows; ++row)
      std::ranges::copy(values.row(first_row + row), halves.row(row).begin());
  }

  void convert(int first_row, int rows) {
    Imf::FrameBuffer frame_buffer;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      const RgbLayer& layer = layers_[i];
      for (std::size_t k = 0; k < halves_[i].size(); ++k)
        convert((*layer.channels)[k], first_row, rows, halves_[i][k]);
      insert_slices(frame_buffer, Imf::HALF, space_, layer.name, halves_[i], {0, first_row});
      if (!layer.alpha) continue;
      convert(*layer.alpha, first_row, rows, half_alphas_[i]);
      frame_buffer.insert(name_in_layer(layer.name, "A"),
                          slice_of(Imf::HALF, half_alphas_[i], {0, first_row}));
    }
    file_.setFrameBuffer(frame_buffer);
  }

  Imf::OutputFile& file_;
  const RgbColorSpace& space_;
  std::span<const RgbLayer> layers_;
  bool as_half_;
  std::vector<std::array<Image<Imath::half>, 3>> halves_;
  std::vector<Image<Imath::half>> half_alphas_;
};

void encode(Imf::OStream& output, const Imf::Header& header, const RgbColorSpace& space,
            std::span<const RgbLayer> layers, const RgbFileOptions& options) {
  const CompressionThreads threads(options.threads);
  Imf::OutputFile file(output, header, threads.count());
  PixelWriter pixels(file, space, layers, options.half);
  for (int row = 0; row < pixels.height(); row += kBandRows) {
    if (options.keep_going && !options.keep_going()) throw Cancelled();
    pixels.write(row, std::min(kBandRows, pixels.height() - row));
  }
}

}  // namespace

std::array<const char*, 3> channel_names(const RgbColorSpace& space) {
  if (space.is_xyz()) return {"X", "Y", "Z"};
  return {"R", "G", "B"};
}

bool fits_half(const Channels& channels) {
  return std::ranges::all_of(channels, [](const Image<float>& channel) {
    return std::ranges::none_of(channel.values(),
                                [](float value) { return std::abs(value) > kLargestHalf; });
  });
}

Imf::Header rgb_header(int width, int height, const RgbColorSpace& space, bool half,
                       std::span<const RgbLayer> layers) {
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  const Imf::Channel channel(half ? Imf::HALF : Imf::FLOAT);
  for (const RgbLayer& layer : layers) {
    for (const char* name : channel_names(space))
      header.channels().insert(name_in_layer(layer.name, name), channel);
    if (layer.alpha) header.channels().insert(name_in_layer(layer.name, "A"), channel);
  }
  if (!space.is_xyz()) Imf::addChromaticities(header, chromaticities_of(space));
  return header;
}

Imf::Header rgb_header(int width, int height, const RgbColorSpace& space, bool half) {
  const RgbLayer root;
  return rgb_header(width, height, space, half, {&root, 1});
}

void write_rgb_layers(const std::filesystem::path& path, const Imf::Header& header,
                      const RgbColorSpace& space, std::span<const RgbLayer> layers,
                      const RgbFileOptions& options) {
  write_openexr_file(path, options.keep_going,
                     [&](Imf::OStream& output) { encode(output, header, space, layers, options); });
}

void write_rgb_file(const std::filesystem::path& path, const Imf::Header& header,
                    const RgbColorSpace& space, const Channels& channels,
                    const RgbFileOptions& options) {
  const RgbLayer layer = {"", &channels, nullptr};
  write_rgb_layers(path, header, space, {&layer, 1}, options);
}

}  // namespace glare::openexr_io
