#include "glare/io/openexr/gray_pixels.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cstddef>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/openexr/file_output.h"

namespace glare::openexr_io {

Imf::Header gray_header(int width, int height) {
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  header.insert("glare:software", Imf::StringAttribute("glare " GLARE_VERSION));
  return header;
}

void write_gray_file(const std::filesystem::path& path, const Imf::Header& header,
                     const Image<float>& values, const std::function<bool()>& keep_going) {
  constexpr int kBandRows = 256;  // Whole blocks of ZIP, 16 rows each.
  AtomicFile file(path);
  FileOutput stream(file);
  try {
    Imf::OutputFile picture(stream, header, 0);
    Imf::FrameBuffer pixels;
    pixels.insert(
        "Y",
        Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(values.values().data())),
                   sizeof(float), sizeof(float) * static_cast<std::size_t>(values.width())));
    picture.setFrameBuffer(pixels);
    for (int row = 0; row < values.height(); row += kBandRows) {
      if (keep_going && !keep_going()) throw Cancelled();
      picture.writePixels(std::min(kBandRows, values.height() - row));
    }
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw OutputError(path.string(), error.what());
  }
  stream.finish();
  file.commit(keep_going);
}

}  // namespace glare::openexr_io
