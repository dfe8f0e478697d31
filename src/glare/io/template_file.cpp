#include "glare/io/template_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <system_error>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/image/image_header.h"
#include "glare/io/openexr/attribute_text.h"
#include "glare/io/openexr/file_output.h"
#include "glare/io/openexr/memory_stream.h"
#include "glare/io/openexr/scan_lines.h"
#include "glare/io/openexr/template_header.h"

namespace glare {

namespace {

constexpr std::uint64_t kLargestFile_bytes = 64ull << 30;
constexpr int kBandRows = 256;  // Whole blocks of ZIP, 16 rows each.

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

template <typename T>
Imf::FrameBuffer frame_buffer_of(Imf::PixelType type, const RgbColorSpace& space,
                                 const std::array<Image<T>, 3>& channels,
                                 const Imath::V2i& origin) {
  const auto names = openexr_io::channel_names(space);
  Imf::FrameBuffer frame_buffer;
  for (std::size_t k = 0; k < names.size(); ++k)
    frame_buffer.insert(names[k], slice_of(type, channels[k], origin));
  return frame_buffer;
}

// Writing.

void require_fits_half(const GlareTemplate& t) {
  for (const auto& channel : t.channels)
    for (const float value : channel.values())
      if (std::abs(value) > kLargestHalf)
        throw OptionError(
            "half precision holds values up to 65504 and this template has larger ones; normalize "
            "it to its peak or write 32-bit floating point");
}

/// Gives OpenEXR the pixels band by band.
class PixelWriter {
 public:
  PixelWriter(Imf::OutputFile& file, const GlareTemplate& t, bool as_half)
      : file_(file), template_(t), as_half_(as_half) {
    if (as_half_)
      halves_.fill(Image<Imath::half>(t.width(), std::min(t.height(), kBandRows)));
    else
      file_.setFrameBuffer(frame_buffer_of(Imf::FLOAT, t.color_space, t.channels, {0, 0}));
  }

  void write(int first_row, int rows) {
    if (as_half_) convert(first_row, rows);
    file_.writePixels(rows);
  }

 private:
  void convert(int first_row, int rows) {
    for (std::size_t k = 0; k < halves_.size(); ++k)
      for (int row = 0; row < rows; ++row)
        std::ranges::copy(template_.channels[k].row(first_row + row), halves_[k].row(row).begin());
    file_.setFrameBuffer(
        frame_buffer_of(Imf::HALF, template_.color_space, halves_, {0, first_row}));
  }

  Imf::OutputFile& file_;
  const GlareTemplate& template_;
  bool as_half_;
  std::array<Image<Imath::half>, 3> halves_;
};

void encode(const GlareTemplate& t, const TemplateFileOptions& options, Imf::OStream& output) {
  const openexr_io::CompressionThreads threads(options.threads);
  Imf::OutputFile file(output, openexr_io::header_of(t, options.half ? Imf::HALF : Imf::FLOAT),
                       threads.count());
  PixelWriter pixels(file, t, options.half);
  for (int row = 0; row < t.height(); row += kBandRows) {
    if (options.keep_going && !options.keep_going()) throw Cancelled();
    pixels.write(row, std::min(kBandRows, t.height() - row));
  }
}

// Reading.

void require_memory(std::uint64_t required_bytes, std::uint64_t limit_bytes) {
  if (required_bytes > limit_bytes) throw MemoryError(required_bytes, limit_bytes);
}

std::vector<std::byte> file_bytes(const std::filesystem::path& path, std::uint64_t limit_bytes) {
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(path, error);
  if (!error) require_memory(size, limit_bytes);
  return read_file(path, kLargestFile_bytes);
}

/// Opens an OpenEXR file and hands it on; whatever is wrong with it becomes an `InputError`.
template <typename Use>
auto with_openexr(const std::filesystem::path& path, std::uint64_t limit_bytes, const Use& use) {
  const std::string place = path.string();
  auto bytes = file_bytes(path, limit_bytes);
  try {
    const openexr_io::ScanLines lines = openexr_io::checked_scan_lines(bytes);
    require_memory(
        bytes.size() + lines.decoder_bytes + lines.width * lines.height * 3 * sizeof(float),
        limit_bytes);
    openexr_io::MemoryInput input(place, std::move(bytes));
    Imf::InputFile file(input, 0);  // No threads: a block of scan lines at a time.
    return use(file, place);
  } catch (const MemoryError&) {
    throw;
  } catch (const InputError& error) {
    throw InputError(place, error.message());
  } catch (const Error& error) {
    throw InputError(place, error.what());
  } catch (const image_io::BadImage& error) {
    throw InputError(place, error.what());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(place, std::string("can't be read as OpenEXR: ") + error.what());
  }
}

GlareTemplate template_in(Imf::InputFile& file, const std::string& place) {
  GlareTemplate t = openexr_io::template_of(file.header(), place);
  const Imath::Box2i window = file.header().dataWindow();
  file.setFrameBuffer(frame_buffer_of(Imf::FLOAT, t.color_space, t.channels, window.min));
  file.readPixels(window.min.y, window.max.y);
  return t;
}

std::vector<HeaderAttribute> header_in(const Imf::InputFile& file) {
  std::vector<HeaderAttribute> result;
  const Imf::Header& header = file.header();
  for (auto a = header.begin(); a != header.end(); ++a)
    result.push_back({a.name(), a.attribute().typeName(), openexr_io::text_of(a.attribute())});
  for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
    result.push_back(
        {std::string("channel ") + c.name(), "chlist", openexr_io::text_of(c.channel().type)});
  return result;
}

}  // namespace

void write_template(const std::filesystem::path& path, const GlareTemplate& glare_template,
                    const TemplateFileOptions& options) {
  if (options.half) require_fits_half(glare_template);
  AtomicFile file(path);
  try {
    openexr_io::FileOutput output(file);
    encode(glare_template, options, output);
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

GlareTemplate read_template(const std::filesystem::path& path, const ReadTemplateOptions& options) {
  return with_openexr(path, options.memory_limit_bytes, template_in);
}

TemplateFile read_template_file(const std::filesystem::path& path,
                                const ReadTemplateOptions& options) {
  return with_openexr(path, options.memory_limit_bytes,
                      [](Imf::InputFile& file, const std::string& place) {
                        return TemplateFile{template_in(file, place), header_in(file)};
                      });
}

std::vector<HeaderAttribute> read_header(const std::filesystem::path& path) {
  return with_openexr(path, UINT64_MAX,
                      [](Imf::InputFile& file, const std::string&) { return header_in(file); });
}

}  // namespace glare
