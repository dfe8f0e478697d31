// How a scene's pictures are brought to a display.
#pragma once

#include <array>
#include <mutex>
#include <string>

#include "glare/base/image.h"
#include "glare/picture/picture.h"
#include "glare/picture/tone_mapping.h"
#include "headlamp/backgrounds.h"
#include "headlamp/scene.h"

namespace glare::tool {

class SceneDisplay {
 public:
  /// Throws `InputError` for a config, a display or a view that there isn't. The scene outlives
  /// this object.
  SceneDisplay(const Scene& scene, const Backgrounds& backgrounds);

  /// R, G, B in 0 to 1, encoded for the display; `picture` may be changed. May be called by several
  /// threads.
  Image<std::array<float, 3>> encoded(Picture& picture, int threads) const;

  /// What it does, in words that are the same for the same display.
  std::string description() const;

 private:
  bool has_view() const { return !scene_.tone_mapping.config.empty(); }

  const Scene& scene_;
  ToneMapping mapping_;
  std::string config_sha256_;
  mutable std::mutex config_mutex_;
};

}  // namespace glare::tool
