// OpenEXR's attributes as text. Internal.
#pragma once

#include <OpenEXR/ImfAttribute.h>
#include <OpenEXR/ImfPixelType.h>

#include <string>

namespace glare::openexr_io {

/// "half", "float" or "uint".
std::string text_of(Imf::PixelType type);

/// The value as text: numbers as short as they can be and still be read back the same, with spaces
/// between; "(N bytes)" for types that aren't written out.
std::string text_of(const Imf::Attribute& attribute);

}  // namespace glare::openexr_io
