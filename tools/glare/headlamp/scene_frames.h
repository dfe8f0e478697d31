// What changes from frame to frame of a scene: where the eye is, and how the lamps are turned.
#pragma once

#include <string>
#include <vector>

#include "glare/scene/camera.h"
#include "glare/scene/lamp_light.h"
#include "headlamp/scene.h"

namespace glare::tool {

struct SceneFrame {
  int index = 0;        ///< From 0 on.
  double turn_deg = 0;  ///< Of every vehicle, and of every lamp without one, to its right.
  Vector3 eye_m{};
};

/// The angles that "LO:HI:STEP" (HI included) or "A,B,C" says, in degrees. Throws `OptionError`.
std::vector<double> turns_from(const std::string& text);

/// The scene's frames: as many as there are turns, or as the viewer's path, or else the sequence of
/// backgrounds has. Throws `InputError` or `OptionError` where they don't agree.
std::vector<SceneFrame> frames_of(const Scene& scene, const std::vector<double>& turns_deg);

/// Where a lamp is in a frame, seen from the eye, and how it stands.
LampPose pose_of(const Scene& scene, std::size_t lamp, const Camera& camera,
                 const SceneFrame& frame);

}  // namespace glare::tool
