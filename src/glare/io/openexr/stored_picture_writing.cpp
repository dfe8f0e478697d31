#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfDeepScanLineOutputPart.h>
#include <OpenEXR/ImfDeepTiledInputPart.h>
#include <OpenEXR/ImfDeepTiledOutputPart.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledInputPart.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "glare/base/error.h"
#include "glare/io/openexr/file_output.h"
#include "glare/io/openexr/memory_stream.h"
#include "glare/io/openexr/part_structure.h"
#include "glare/io/openexr/pixel_bands.h"
#include "glare/io/openexr/shared_input.h"
#include "glare/io/openexr/stored_picture.h"

namespace glare::openexr_io {

namespace {

constexpr int kBandRows = 256;  // Whole blocks, of any compression.

bool has_levels(const Imf::Header& header) {
  return is_tiled(header) && header.tileDescription().mode != Imf::ONE_LEVEL;
}

/// Writes the changed part, band by band: rows of blocks or of tiles.
class PartWriter {
 public:
  PartWriter(Imf::MultiPartInputFile& input, const StoredPicture& stored, const Picture& changed,
             const std::function<bool()>& keep_going)
      : input_(input),
        part_(stored.part),
        header_(input.header(stored.part)),
        band_rows_(is_tiled(header_)
                       ? static_cast<int>(std::min(header_.tileDescription().ySize, 65535u))
                       : kBandRows),
        kept_(header_, stored.color_channels, std::min(band_rows_, changed.height())),
        colors_(header_, stored.color_channels, changed, std::min(band_rows_, changed.height())),
        keep_going_(keep_going) {}

  template <typename Output>
  void write_rows(Output& output) {
    Imf::InputPart input(input_, part_);
    for_each_band([&](int, int y, int rows) {
      if (!kept_.empty()) {
        input.setFrameBuffer(kept_slices(y));
        input.readPixels(y, y + rows - 1);
      }
      output.setFrameBuffer(all_slices(y, rows));
      output.writePixels(rows);
    });
  }

  template <typename Output>
  void write_tiles(Output& output) {
    Imf::TiledInputPart input(input_, part_);
    const int last = input.numXTiles(0) - 1;
    for_each_band([&](int band, int y, int rows) {
      if (!kept_.empty()) {
        input.setFrameBuffer(kept_slices(y));
        input.readTiles(0, last, band, band, 0, 0);
      }
      output.setFrameBuffer(all_slices(y, rows));
      output.writeTiles(0, last, band, band, 0, 0);
    });
  }

  std::uint64_t limited_pixels() const { return colors_.limited_pixels(); }

 private:
  /// In the order in which the file has them.
  template <typename Use>
  void for_each_band(const Use& use) const {
    const auto [min, max] = header_.dataWindow();
    const int bands = (max.y - min.y) / band_rows_ + 1;
    for (int i = 0; i < bands; ++i) {
      if (keep_going_ && !keep_going_()) throw Cancelled();
      const int band = header_.lineOrder() == Imf::DECREASING_Y ? bands - 1 - i : i;
      const int y = min.y + band * band_rows_;
      use(band, y, std::min(band_rows_, max.y - y + 1));
    }
  }

  Imf::FrameBuffer kept_slices(int y) {
    Imf::FrameBuffer frame_buffer;
    kept_.add_slices(frame_buffer, y);
    return frame_buffer;
  }

  Imf::FrameBuffer all_slices(int y, int rows) {
    Imf::FrameBuffer frame_buffer = kept_slices(y);
    colors_.add_slices(frame_buffer, y, rows);
    return frame_buffer;
  }

  Imf::MultiPartInputFile& input_;
  int part_;
  const Imf::Header& header_;
  int band_rows_;
  KeptBand kept_;
  ColorBand colors_;
  const std::function<bool()>& keep_going_;
};

/// The header without some attributes: `Imf::Header::erase` leaks them. As every attribute is set
/// anew, OpenEXR takes over the level of DWA's loss too, which it doesn't when it reads a header.
Imf::Header without(const Imf::Header& header, const std::set<std::string>& names) {
  Imf::Header rest;
  for (auto a = header.begin(); a != header.end(); ++a)
    if (!names.contains(a.name())) rest.insert(a.name(), a.attribute());
  return rest;
}

/// The header as it is written: of several levels the full one is left.
Imf::Header written_header(const Imf::MultiPartInputFile& file, int part, bool with_type) {
  const Imf::Header& stored = file.header(part);
  std::set<std::string> dropped;
  if (!with_type) dropped.insert("type");
  if (has_levels(stored)) dropped.insert("chunkCount");
  Imf::Header header = without(stored, dropped);
  if (has_levels(stored)) {
    const Imf::TileDescription& tiles = stored.tileDescription();
    header.setTileDescription({tiles.xSize, tiles.ySize, Imf::ONE_LEVEL});
  }
  return header;
}

template <typename Input, typename Output>
void copy_raw(Imf::MultiPartInputFile& from, Imf::MultiPartOutputFile& to, int part) {
  Input input(from, part);
  Output output(to, part);
  output.copyPixels(input);
}

void copy_part(Imf::MultiPartInputFile& from, Imf::MultiPartOutputFile& to, int part) {
  const std::string& type = from.header(part).type();
  if (type == Imf::SCANLINEIMAGE)
    copy_raw<Imf::InputPart, Imf::OutputPart>(from, to, part);
  else if (type == Imf::TILEDIMAGE)
    copy_raw<Imf::TiledInputPart, Imf::TiledOutputPart>(from, to, part);
  else if (type == Imf::DEEPSCANLINE)
    copy_raw<Imf::DeepScanLineInputPart, Imf::DeepScanLineOutputPart>(from, to, part);
  else
    copy_raw<Imf::DeepTiledInputPart, Imf::DeepTiledOutputPart>(from, to, part);
}

void write_only_part(PartWriter& writer, Imf::MultiPartInputFile& input, Imf::OStream& stream,
                     const image_io::Bytes& file, int threads) {
  // OpenEXR adds the type on reading.
  const Imf::Header header = written_header(input, 0, has_type_attribute(file));
  if (is_tiled(input.header(0))) {
    Imf::TiledOutputFile output(stream, header, threads);
    writer.write_tiles(output);
  } else {
    Imf::OutputFile output(stream, header, threads);
    writer.write_rows(output);
  }
}

void write_all_parts(PartWriter& writer, Imf::MultiPartInputFile& input, Imf::OStream& stream,
                     int changed_part, int threads) {
  std::vector<Imf::Header> headers;
  for (int part = 0; part < input.parts(); ++part)
    headers.push_back(part == changed_part ? written_header(input, part, true)
                                           : input.header(part));
  Imf::MultiPartOutputFile output(stream, headers.data(), input.parts(), false, threads);
  for (int part = 0; part < input.parts(); ++part) {
    if (part != changed_part) {
      copy_part(input, output, part);
    } else if (is_tiled(input.header(part))) {
      Imf::TiledOutputPart tiles(output, part);
      writer.write_tiles(tiles);
    } else {
      Imf::OutputPart rows(output, part);
      writer.write_rows(rows);
    }
  }
}

}  // namespace

std::uint64_t write_stored_picture(const std::filesystem::path& path, const StoredPicture& stored,
                                   const Picture& changed, const PictureWriting& options) {
  std::uint64_t limited = 0;
  write_openexr_file(path, options.keep_going, [&](Imf::OStream& stream) {
    const CompressionThreads threads(options.threads);
    SharedInput shared(stored.file);
    Imf::MultiPartInputFile input(shared, threads.count(), false);
    PartWriter writer(input, stored, changed, options.keep_going);
    if (input.parts() == 1)
      write_only_part(writer, input, stream, *stored.file, threads.count());
    else
      write_all_parts(writer, input, stream, stored.part, threads.count());
    limited = writer.limited_pixels();
  });
  return limited;
}

}  // namespace glare::openexr_io
