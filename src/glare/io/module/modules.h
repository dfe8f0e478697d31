// The modules: the parts of glare::io that stand on OpenImageIO, OpenColorIO and OpenCV. Internal.
//
// These libraries and the 250 that they stand on take a quarter of a second and 120 MB to load, and
// most runs of the program need neither. So in a shared build each part is a file of its own, which
// is loaded on first use (loaded_modules.cpp); in a static build it is linked in like the rest
// (linked_modules.cpp).
#pragma once

#include "glare/io/module/color_config_reader.h"
#include "glare/io/module/eye_photo_reader.h"
#include "glare/io/module/image_codec.h"

namespace glare::module {

/// Decodes and encodes pictures, with OpenImageIO. Throws `Error` where it can't be loaded.
const ImageCodec& image_codec();

/// Reads colour spaces from configs, with OpenColorIO. Throws `Error` where it can't be loaded.
const ColorConfigReader& color_config_reader();

/// Finds the eye in a photograph, with OpenCV. Throws `Error` where it can't be loaded.
const EyePhotoReader& eye_photo_reader();

}  // namespace glare::module
