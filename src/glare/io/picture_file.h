// Colour pictures in files: scene-linear ones from OpenEXR, Radiance HDR and ordinary pictures, and
// back to OpenEXR.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "glare/picture/picture.h"

namespace glare {

struct PictureFile {
  Picture
      picture;  ///< Linear light, in the file's own chromaticities (BT.709 where it tells none).
  /// True for 8 and 16-bit pictures, whose sRGB transfer curve was undone; 1 is then their white.
  bool was_display_encoded = false;
  std::vector<std::string> warnings;  ///< One line each, without the file's name.
};

/// Throws `InputError`, `MemoryError`.
PictureFile read_picture(const std::filesystem::path& path, std::uint64_t max_bytes);

struct PictureFileOptions {
  bool half = false;
  int threads = 0;
  std::map<std::string, std::string> attributes;  ///< Further string attributes of the header.
  std::function<bool()> keep_going;
};

/// Writes OpenEXR: scan lines, ZIP, channels R G B (X Y Z for "xyz") and chromaticities, all or
/// nothing, the same bytes for the same picture. Throws `OutputError`, `Cancelled`; `OptionError`
/// where half can't hold the values.
void write_picture(const std::filesystem::path& path, const Picture& picture,
                   const PictureFileOptions& options = {});

/// A colour layer of a picture file.
struct PictureLayer {
  std::string name;  ///< Channels NAME.R, NAME.G, NAME.B; empty: R, G, B.
  const Picture* picture = nullptr;
  const Image<float>* alpha = nullptr;  ///< A channel A of the same size, if there is one.
};

/// The same with several layers, each of its own name, of one size and one colour space. Throws
/// `OptionError` where they aren't.
void write_picture_layers(const std::filesystem::path& path, std::span<const PictureLayer> layers,
                          const PictureFileOptions& options = {});

}  // namespace glare
