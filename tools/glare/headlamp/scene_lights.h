// What of each lamp's light reaches the eye, frame by frame.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "console.h"
#include "glare/photometry/luminous_intensity.h"
#include "glare/scene/camera.h"
#include "glare/scene/lamp_light.h"
#include "headlamp/scene.h"
#include "headlamp/scene_frames.h"

namespace glare::tool {

/// A lamp in a frame.
struct SceneLight {
  LightAtEye at_eye;
  double off_axis_deg = 0;                     ///< From the line of sight.
  std::optional<std::array<double, 2>> pixel;  ///< Column and row; none behind the viewer.
  double relative_luminance = 0;               ///< L0 of the paper's mode.
};

class SceneLights {
 public:
  /// Reads the lamps' intensities. Throws `InputError`, `MemoryError`. The scene outlives this
  /// object.
  SceneLights(const Scene& scene, std::uint64_t memory_limit_bytes, const Console& console);

  /// Throws `InputError` where the eye is in the lamp's place.
  SceneLight light(std::size_t lamp, const Camera& camera, const SceneFrame& frame) const;

  /// Whether a lamp's file is of type C.
  bool is_type_c(std::size_t lamp) const {
    return distributions_[lamp] && distributions_[lamp]->type() == PhotometricType::c;
  }

  /// SHA-256 of a lamp's intensities; empty for a constant.
  const std::string& sha256(std::size_t lamp) const { return sha256_[lamp]; }

 private:
  const Scene& scene_;
  std::vector<std::optional<LuminousIntensityDistribution>> distributions_;  ///< Of each lamp.
  std::vector<std::string> sha256_;
};

}  // namespace glare::tool
