// The modules of a static build: parts of the program like the rest, so that it needs no file
// beside it.
#include "glare/io/module/modules.h"

namespace glare::module {

const ImageCodec& image_codec() { return glare_image_codec; }

const ColorConfigReader& color_config_reader() { return glare_color_config; }

const EyePhotoReader& eye_photo_reader() { return glare_eye_photo; }

}  // namespace glare::module
