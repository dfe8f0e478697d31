// How large a picture's pixels are, and what is worth telling about it.
#pragma once

#include <string>

#include "apply/apply_arguments.h"
#include "glare/convolution/pixel_kernel.h"
#include "glare/io/picture_document.h"
#include "glare/template/glare_template.h"

namespace glare::tool {

struct ScaledPicture {
  PixelScale scale;
  std::string source;  ///< An option, or the file's attributes.
};

/// From --fov-deg, --pixel-deg or the file. `file` is the picture's name for messages. Throws
/// `OptionError` where none of them tells it, `InputError` for a file's aspect out of range.
ScaledPicture scale_of(const PictureDocument& document, const std::string& file,
                       const ApplyArguments& arguments);

/// A note on both scales, and warnings where they hardly go together.
void tell_scale(const ScaledPicture& scaled, const GlareTemplate& glare_template,
                const PictureDocument& document, const ApplyArguments& arguments,
                const Console& console);

}  // namespace glare::tool
