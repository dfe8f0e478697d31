// A template's numbers and texts as the attributes of an OpenEXR header. Internal.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <string>

#include "glare/template/glare_template.h"

namespace glare::openexr_io {

/// The header of the template's file, complete.
Imf::Header header_of(const GlareTemplate& glare_template, bool half);

/// What the header says, all but the pixels: those are 0. Throws `InputError` with the place where
/// an attribute or a channel is missing or not as it should be.
GlareTemplate template_of(const Imf::Header& header, const std::string& place);

}  // namespace glare::openexr_io
