// A scene's picture at one moment.
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "glare/base/parallel.h"
#include "glare/scene/point_glare.h"
#include "headlamp/headlamp_arguments.h"
#include "headlamp/scene_parts.h"

namespace glare::tool {

class FrameMaker {
 public:
  /// Prepares the templates for the picture; the parts outlive it. Throws `InputError`,
  /// `OptionError`.
  explicit FrameMaker(const SceneParts& parts);

  /// `result` becomes the background with the veil of every lamp, in cd/m^2 or in the paper's unit;
  /// its memory is used again. May be called by several threads.
  void make_picture(const SceneFrame& frame, Picture& result, int threads) const;

  /// Writes the picture, as the file's ending says, and returns the file's SHA-256. What half
  /// precision can't hold is limited to its largest value. Throws `OutputError`, `Cancelled`.
  std::string write(const SceneFrame& frame, const std::filesystem::path& file,
                    const HeadlampArguments& arguments, int threads) const;

  /// How many of the frames written had pixels that were limited.
  int limited_frames() const { return limited_frames_; }

 private:
  double illuminance_lux(const SceneLight& light, std::size_t lamp) const;

  SceneParts parts_;
  std::vector<GlareKernel> kernels_;  ///< Of each template.
  mutable WorkspacePool<Picture> pictures_;
  mutable std::atomic<int> limited_frames_{0};
};

}  // namespace glare::tool
