// A picture in an OpenEXR file of any kind: its colours, to be written again among all else that
// the file holds. Internal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glare/io/image/byte_reader.h"
#include "glare/io/picture_document.h"

namespace glare::openexr_io {

/// A file and where its colours are. The pixels that stay are decoded only while they are written.
struct StoredPicture {
  std::shared_ptr<const image_io::Bytes> file;
  int part = 0;
  std::vector<std::string> color_channels;  ///< Three, or one.
};

struct ReadPicture {
  StoredPicture stored;
  Picture picture;
  double pixel_aspect = 1;
  int display_width = 0;  ///< 0 where the file tells none that makes sense.
  std::optional<ToldPixelPitch> pitch;
  std::vector<std::string> warnings;
};

/// Throws `image_io::BadImage`, and what OpenEXR throws; `MemoryError`.
ReadPicture read_stored_picture(image_io::Bytes file, const PictureDocumentOptions& options);

/// The file with the pixels of `changed` in the place of its colours. Returns how many pixels were
/// limited to what half precision holds. Throws `OutputError`, `Cancelled`.
std::uint64_t write_stored_picture(const std::filesystem::path& path, const StoredPicture& stored,
                                   const Picture& changed, const PictureWriting& options);

}  // namespace glare::openexr_io
