#include "glare/io/openexr/rgb_pixels.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <string>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
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
  PixelWriter(Imf::OutputFile& file, const RgbColorSpace& space, const Channels& channels,
              bool as_half)
      : file_(file), space_(space), channels_(channels), as_half_(as_half) {
    if (as_half_)
      halves_.fill(Image<Imath::half>(channels[0].width(), std::min(height(), kBandRows)));
    else
      file_.setFrameBuffer(frame_buffer_of(Imf::FLOAT, space, channels, {0, 0}));
  }

  int height() const { return channels_[0].height(); }

  void write(int first_row, int rows) {
    if (as_half_) convert(first_row, rows);
    file_.writePixels(rows);
  }

 private:
  void convert(int first_row, int rows) {
    for (std::size_t k = 0; k < halves_.size(); ++k)
      for (int row = 0; row < rows; ++row)
        std::ranges::copy(channels_[k].row(first_row + row), halves_[k].row(row).begin());
    file_.setFrameBuffer(frame_buffer_of(Imf::HALF, space_, halves_, {0, first_row}));
  }

  Imf::OutputFile& file_;
  const RgbColorSpace& space_;
  const Channels& channels_;
  bool as_half_;
  std::array<Image<Imath::half>, 3> halves_;
};

void encode(Imf::OStream& output, const Imf::Header& header, const RgbColorSpace& space,
            const Channels& channels, const RgbFileOptions& options) {
  const CompressionThreads threads(options.threads);
  Imf::OutputFile file(output, header, threads.count());
  PixelWriter pixels(file, space, channels, options.half);
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

Imf::Header rgb_header(int width, int height, const RgbColorSpace& space, bool half) {
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* name : channel_names(space))
    header.channels().insert(name, Imf::Channel(half ? Imf::HALF : Imf::FLOAT));
  if (!space.is_xyz()) Imf::addChromaticities(header, chromaticities_of(space));
  return header;
}

void write_rgb_file(const std::filesystem::path& path, const Imf::Header& header,
                    const RgbColorSpace& space, const Channels& channels,
                    const RgbFileOptions& options) {
  AtomicFile file(path);
  try {
    FileOutput output(file);
    encode(output, header, space, channels, options);
    output.finish();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw OutputError(path.string(), std::string("can't be encoded: ") + error.what());
  }
  file.commit(options.keep_going);
}

}  // namespace glare::openexr_io
