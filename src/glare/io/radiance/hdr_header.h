// The header of a Radiance picture: lines of text, which are kept as they are. Internal.
// (G. Ward, "Radiance File Formats", https://radsite.lbl.gov/radiance/refer/filefmts.pdf)
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glare/io/image/byte_reader.h"
#include "glare/io/picture_document.h"

namespace glare::radiance_io {

struct HdrHeader {
  std::vector<std::string> lines;  ///< All before the empty one, the first (#?RADIANCE) included.
  RgbColorSpace color_space = lin_rec709_color_space();
  double pixel_aspect = 1;  ///< Width by height; the file has the inverse, as PIXASPECT.
};

/// Of a whole file, whose format is known: the space of the last line PRIMARIES (CIE XYZ where
/// FORMAT says so), the product of all lines PIXASPECT. Throws `image_io::BadImage`.
HdrHeader hdr_header(const image_io::Bytes& file);

/// For a picture of another kind.
HdrHeader new_hdr_header(const RgbColorSpace& space, double pixel_aspect);

/// From the last line VIEW, where that is of a perspective and tells its whole angle (-vh).
std::optional<ToldPixelPitch> told_pixel_pitch(const HdrHeader& header, int width);

/// The file with its pixels said to be RGB where they are XYZ, which are coded in the same way.
void call_rgbe(image_io::Bytes& file);

}  // namespace glare::radiance_io
