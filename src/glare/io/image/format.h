// The formats of pictures that are read, told by a file's first bytes. Internal.
#pragma once

#include "glare/io/image/byte_reader.h"
#include "glare/io/image/image_header.h"

namespace glare::image_io {

struct Format {
  const char* name;             ///< For people.
  const char* reader;           ///< OpenImageIO's name.
  Header (*checked)(Bytes&);    ///< Of structure.h.
  bool names_channels = false;  ///< Channels go by their names, not by their places.
};

/// The format of the file with this content, whatever its name. Throws `BadImage`, with what it is
/// instead, where it is none of them.
const Format& recognized_format(const Bytes& bytes);

}  // namespace glare::image_io
