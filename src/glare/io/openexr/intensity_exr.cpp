#include "glare/io/openexr/intensity_exr.h"

#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include "glare/io/image/intensities.h"
#include "glare/io/openexr/gray_pixels.h"

namespace glare::openexr_io {

void write_intensities(const std::filesystem::path& path, const Image<float>& candela,
                       const IntensityGrid& grid, const std::function<bool()>& keep_going) {
  Imf::Header header = gray_header(grid.width, grid.height);
  const auto insert_range = [&](const char* name, const std::array<double, 2>& range_deg) {
    header.insert(name, Imf::V2dAttribute({range_deg[0], range_deg[1]}));
  };
  insert_range(image_io::kHorizontalRangeTag, grid.h_deg);
  insert_range(image_io::kVerticalRangeTag, grid.v_deg);
  header.insert("glare:quantity", Imf::StringAttribute("luminous intensity, cd"));
  write_gray_file(path, header, candela, keep_going);
}

}  // namespace glare::openexr_io
