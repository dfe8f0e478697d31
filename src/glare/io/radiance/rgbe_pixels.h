// Pixels as Radiance codes them: three mantissas of 8 bits and an exponent that they share, in
// runs. The decoder is OpenImageIO's; its encoder is not used because it writes only the few lines
// of a header that it knows, and the others would be lost. Internal.
#pragma once

#include <cstdint>

#include "glare/io/image/byte_reader.h"
#include "glare/picture/picture.h"

namespace glare::radiance_io {

/// The rows of a picture, to be put behind its header. Mantissas are cut off, so that what was
/// decoded is coded as it was, whether the decoder takes a step's begin or its middle. Values that
/// the code can't hold become 0 (negative ones and NaN) or the largest one, 255/256 2^127; adds the
/// number of pixels with such values to `limited`.
image_io::Bytes rgbe_rows(const Picture& picture, std::uint64_t& limited);

}  // namespace glare::radiance_io
