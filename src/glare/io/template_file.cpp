#include "glare/io/template_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include <new>
#include <system_error>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/image/image_header.h"
#include "glare/io/openexr/attribute_text.h"
#include "glare/io/openexr/memory_stream.h"
#include "glare/io/openexr/rgb_pixels.h"
#include "glare/io/openexr/scan_lines.h"
#include "glare/io/openexr/template_header.h"

namespace glare {

namespace {

constexpr std::uint64_t kLargestFile_bytes = 64ull << 30;

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
  file.setFrameBuffer(
      openexr_io::frame_buffer_of(Imf::FLOAT, t.color_space, t.channels, window.min));
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

void write_template(const std::filesystem::path& path, const GlareTemplate& t,
                    const TemplateFileOptions& options) {
  if (options.half && !openexr_io::fits_half(t.channels))
    throw OptionError(
        "half precision holds values up to 65504 and this template has larger ones; normalize "
        "it to its peak or write 32-bit floating point");
  openexr_io::write_rgb_file(path, openexr_io::header_of(t, options.half), t.color_space,
                             t.channels, {options.half, options.threads, options.keep_going});
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
