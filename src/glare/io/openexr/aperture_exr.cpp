#include "glare/io/openexr/aperture_exr.h"

#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "glare/io/openexr/gray_pixels.h"

namespace glare::openexr_io {

void write_aperture(const std::filesystem::path& path, const Aperture& aperture,
                    const std::string& recipe, const std::function<bool()>& keep_going) {
  Imf::Header header = gray_header(aperture.transmittance.width(), aperture.transmittance.height());
  header.insert("glare:apertureWidth_mm",
                Imf::FloatAttribute(static_cast<float>(aperture.width_mm)));
  header.insert("glare:recipe", Imf::StringAttribute(recipe));
  write_gray_file(path, header, aperture.transmittance, keep_going);
}

}  // namespace glare::openexr_io
