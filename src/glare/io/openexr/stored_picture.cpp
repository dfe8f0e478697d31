#include "glare/io/openexr/stored_picture.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfTiledInputPart.h>

#include <algorithm>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/file_color_space.h"
#include "glare/io/openexr/camera_attributes.h"
#include "glare/io/openexr/color_channels.h"
#include "glare/io/openexr/memory_stream.h"
#include "glare/io/openexr/part_structure.h"
#include "glare/io/openexr/pixel_bands.h"
#include "glare/io/openexr/rgb_pixels.h"
#include "glare/io/openexr/shared_input.h"

namespace glare::openexr_io {

using image_io::BadImage;
using image_io::Bytes;

namespace {

int checked_part(const Imf::MultiPartInputFile& file, int part) {
  const int chosen = std::max(part, 0);
  if (chosen >= file.parts())
    throw BadImage("has no part " + std::to_string(chosen) + "; it has " +
                   std::to_string(file.parts()) + " (counted from 0)");
  return chosen;
}

Chromaticity chromaticity_of(const Imath::V2f& v) { return {v.x, v.y}; }

RgbColorSpace space_of(const Imf::Header& header, const ColorChannels& color) {
  if (color.is_xyz) return xyz_color_space();
  if (!Imf::hasChromaticities(header)) return lin_rec709_color_space();
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  const auto* const name = header.findTypedAttribute<Imf::StringAttribute>("glare:colorSpace");
  return color_space_with({chromaticity_of(c.red), chromaticity_of(c.green),
                           chromaticity_of(c.blue), chromaticity_of(c.white)},
                          name ? name->value() : "");
}

Picture pixels_of(Imf::MultiPartInputFile& file, int part, const ColorChannels& color) {
  const Imf::Header& header = file.header(part);
  const Imath::Box2i window = header.dataWindow();
  Picture picture;
  picture.color_space = space_of(header, color);
  Imf::FrameBuffer frame_buffer;
  for (std::size_t k = 0; k < color.names.size(); ++k) {
    picture.channels[k] =
        Image<float>(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
    frame_buffer.insert(color.names[k], slice_of(Imf::FLOAT, picture.channels[k], window.min));
  }
  if (is_tiled(header)) {
    Imf::TiledInputPart tiles(file, part);
    tiles.setFrameBuffer(frame_buffer);
    tiles.readTiles(0, tiles.numXTiles(0) - 1, 0, tiles.numYTiles(0) - 1, 0, 0);
  } else {
    Imf::InputPart rows(file, part);
    rows.setFrameBuffer(frame_buffer);
    rows.readPixels(window.min.y, window.max.y);
  }
  if (color.is_gray()) picture.channels[1] = picture.channels[2] = picture.channels[0];
  return picture;
}

bool is_lossy(Imf::Compression compression) {
  return compression == Imf::PXR24_COMPRESSION || compression == Imf::B44_COMPRESSION ||
         compression == Imf::B44A_COMPRESSION || compression == Imf::DWAA_COMPRESSION ||
         compression == Imf::DWAB_COMPRESSION;
}

/// Whether this compression changes values of this type. PXR24 drops the last byte of floats.
bool degrades(Imf::Compression compression, Imf::PixelType type) {
  if (compression == Imf::PXR24_COMPRESSION) return false;  // What is dropped is gone already.
  if (compression == Imf::B44_COMPRESSION || compression == Imf::B44A_COMPRESSION)
    return type == Imf::HALF;
  return is_lossy(compression) && type != Imf::UINT;
}

std::vector<std::string> warnings_of(const Imf::Header& header, const ColorChannels& color) {
  std::vector<std::string> warnings;
  bool others_degrade = false;
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
    others_degrade = others_degrade || (std::ranges::count(color.names, c.name()) == 0 &&
                                        degrades(header.compression(), c.channel().type));
  if (others_degrade)
    warnings.push_back(
        "its compression is lossy: the other channels are compressed a second time too");
  if (is_tiled(header) && header.tileDescription().mode != Imf::ONE_LEVEL)
    warnings.push_back("only the full size of its several levels is written again");
  if (Imf::hasEnvmap(header))
    warnings.push_back(
        "it is an environment map: its pixels are of different angles, and only those along the "
        "middle are as wide as is taken for all");
  return warnings;
}

}  // namespace

ReadPicture read_stored_picture(Bytes bytes, const PictureDocumentOptions& options) {
  const CompressionThreads threads(0);
  const PartStructure structure = checked_parts(bytes, std::max(options.part, 0), threads.count());
  const std::uint64_t needed = bytes.size() + structure.decoder_bytes + structure.pixels * 12;
  if (needed > options.max_bytes) throw MemoryError(needed, options.max_bytes);
  const auto shared = std::make_shared<const Bytes>(std::move(bytes));
  SharedInput input(shared);
  Imf::MultiPartInputFile file(input, threads.count(), false);
  const int part = checked_part(file, options.part);
  const Imf::Header& header = file.header(part);
  const ColorChannels color = color_channels(header.channels(), options.layer);
  ReadPicture read;
  read.picture = pixels_of(file, part, color);
  read.pixel_aspect = header.pixelAspectRatio();
  const auto& display = header.displayWindow();
  read.display_width = static_cast<int>(
      std::clamp<std::int64_t>(std::int64_t{display.max.x} - display.min.x + 1, 0, 1 << 24));
  read.pitch = told_pixel_pitch(header);
  read.warnings = warnings_of(header, color);
  read.stored = {shared, part, color.names};
  return read;
}

}  // namespace glare::openexr_io
