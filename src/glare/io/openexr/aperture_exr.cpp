#include "glare/io/openexr/aperture_exr.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/openexr/file_output.h"

namespace glare::openexr_io {

namespace {

Imf::Header header_of(const Aperture& aperture, const std::string& recipe) {
  Imf::Header header(aperture.transmittance.width(), aperture.transmittance.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  header.insert("glare:apertureWidth_mm",
                Imf::FloatAttribute(static_cast<float>(aperture.width_mm)));
  header.insert("glare:recipe", Imf::StringAttribute(recipe));
  header.insert("glare:software", Imf::StringAttribute("glare " GLARE_VERSION));
  return header;
}

}  // namespace

void write_aperture(const std::filesystem::path& path, const Aperture& aperture,
                    const std::string& recipe, const std::function<bool()>& keep_going) {
  constexpr int kBandRows = 256;  // Whole blocks of ZIP, 16 rows each.
  const Image<float>& t = aperture.transmittance;
  AtomicFile file(path);
  FileOutput stream(file);
  try {
    Imf::OutputFile picture(stream, header_of(aperture, recipe), 0);
    Imf::FrameBuffer pixels;
    pixels.insert(
        "Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(t.values().data())),
                        sizeof(float), sizeof(float) * static_cast<std::size_t>(t.width())));
    picture.setFrameBuffer(pixels);
    for (int row = 0; row < t.height(); row += kBandRows) {
      if (keep_going && !keep_going()) throw Cancelled();
      picture.writePixels(std::min(kBandRows, t.height() - row));
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
