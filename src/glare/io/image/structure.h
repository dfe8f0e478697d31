// The checks of a file's structure, one for each format, each in a source file of its name.
// Internal.
//
// OpenImageIO trusts what a file says: it crashes on some colour profiles and Exif blocks, it
// allocates what a header of 40 bytes asks for, and it returns true for some files that are cut
// short. So a file is not handed to it as it is: these functions come before.
#pragma once

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/image_header.h"

namespace glare::image_io {

/// Each walks through the structure of a file whose first bytes tell its format, requires what
/// Glare needs, and leaves in `bytes` only the parts that hold pixels (no profiles, texts,
/// thumbnails, private tags). What it allocates is bounded by the bytes that are there. The header
/// it returns bounds what the decoder takes. Each throws `BadImage` for a file that is damaged, cut
/// short, or of a kind that Glare does not read.
Header checked_png(Bytes& bytes);
Header checked_jpeg(Bytes& bytes);
Header checked_tiff(Bytes& bytes);
Header checked_exr(Bytes& bytes);
Header checked_pnm(Bytes& bytes);  ///< PBM, PGM, PPM and PFM.
Header checked_bmp(Bytes& bytes);
Header checked_hdr(Bytes& bytes);  ///< Radiance HDR.

}  // namespace glare::image_io
