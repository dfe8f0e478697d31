// The pictures behind a scene's lamps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "console.h"
#include "glare/picture/picture.h"
#include "glare/scene/camera.h"
#include "headlamp/scene.h"

namespace glare::tool {

/// The luminance of white in 8 and 16-bit pictures, unless the scene tells: a usual display's.
inline constexpr double kDisplayWhite_cd_m2 = 100;

class Backgrounds {
 public:
  /// Reads the first one. Throws `InputError` where it, or another of so many frames, isn't there,
  /// `MemoryError`. The scene outlives this object.
  Backgrounds(const Scene& scene, int frames, std::uint64_t memory_limit_bytes,
              const Console& console);

  const Camera& camera() const { return camera_; }
  const RgbColorSpace& color_space() const { return first_.color_space; }

  /// `result` becomes the picture of a frame, from 0 on, in cd/m^2; its memory is used again where
  /// it has the size. May be called by several threads. Throws `InputError` for one of another size
  /// or colour space than the first.
  void copy_picture(int frame, Picture& result) const;
  /// Reads so many frames' pictures, and throws what `copy_picture` does.
  void require_all(int frames) const;
  /// SHA-256 of a frame's file; empty where there is none.
  std::string sha256(int frame) const;
  /// The files of so many frames; empty for a plain one.
  std::vector<std::filesystem::path> files(int frames) const;

 private:
  std::filesystem::path file_of(int frame) const;
  Picture read(int frame, const Console& console) const;

  const Scene& scene_;
  std::uint64_t memory_limit_bytes_;
  Picture first_;
  Camera camera_;
  std::string sha256_;  ///< Of the one file, where there is no sequence.
};

}  // namespace glare::tool
