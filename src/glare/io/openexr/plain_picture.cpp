#include "glare/io/openexr/plain_picture.h"

#include "glare/io/openexr/rgb_pixels.h"

namespace glare::openexr_io {

void write_plain_picture(const std::filesystem::path& path, const Picture& picture,
                         double pixel_aspect, const PictureWriting& options) {
  Imf::Header header =
      rgb_header(picture.width(), picture.height(), picture.color_space, /*half=*/false);
  header.pixelAspectRatio() = static_cast<float>(pixel_aspect);
  write_rgb_file(path, header, picture.color_space, picture.channels,
                 {false, options.threads, options.keep_going});
}

}  // namespace glare::openexr_io
