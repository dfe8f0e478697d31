// A picture in a file together with all else that the file holds, to be written again with other
// pixels.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glare/picture/picture.h"

namespace glare {

struct PictureDocumentOptions {
  int part = -1;      ///< Of an OpenEXR file, from 0; -1: the first.
  std::string layer;  ///< Channels LAYER.R, LAYER.G, LAYER.B; empty: R, G, B.
  std::uint64_t max_bytes = UINT64_MAX;
};

/// The angle from pixel to pixel that a file tells.
struct ToldPixelPitch {
  double pitch_rad = 0;  ///< Across, at the picture's centre.
  std::string source;    ///< The attributes it was worked out from, for a message.
};

struct PictureWriting {
  int threads = 0;
  std::function<bool()> keep_going;
};

/// Of an OpenEXR file (scan lines or tiles, one part or several) or a Radiance HDR: its colour
/// pixels, which may be changed, and everything else, which is kept: other channels, layers and
/// parts, alpha, windows, pixel aspect, attributes, each channel's type, compression and line
/// order. Cheap to copy.
class PictureDocument {
 public:
  /// Throws `InputError`, with what was found and what was expected: deep pixels, subsampled colour
  /// channels, an empty data window, no such part or layer, a damaged file. `MemoryError`. Pictures
  /// of other formats are read too (see `read_picture`), with a warning where they aren't linear.
  static PictureDocument read(const std::filesystem::path& path,
                              const PictureDocumentOptions& options = {});

  /// The pixels of the data window, scene-linear, as stored (so they may be NaN or infinite), in
  /// the file's chromaticities (BT.709 where it tells none). A grey picture has three equal
  /// channels.
  const Picture& picture() const;
  bool is_gray() const;
  /// Of the whole picture (the display window), which a field of view goes across: the data may be
  /// a part of it or reach beyond it.
  int display_width() const;
  double pixel_aspect() const;
  std::optional<ToldPixelPitch> pixel_pitch() const;
  const std::vector<std::string>& warnings() const;
  /// What a file of this path's type can't hold of this one; one line each, without a name.
  std::vector<std::string> losses(const std::filesystem::path& path) const;

  /// Writes the file again with these pixels, of the same size, in the place of its own (of a grey
  /// picture their first channel); all or nothing. The type is the path's: .exr or .hdr, else
  /// `OptionError`. An .hdr file, and an .exr that was an .hdr, have the colours and what both can
  /// hold. Returns the number of pixels that half precision, or RGBE, could not hold, which are
  /// limited to its largest (smallest) value. Throws `OutputError`, `Cancelled`.
  std::uint64_t write(const std::filesystem::path& path, const Picture& changed,
                      const PictureWriting& options = {}) const;

  struct Content;  ///< Internal.

 private:
  std::shared_ptr<const Content> content_;
};

}  // namespace glare
