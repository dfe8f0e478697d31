// What a driver sees of headlamps: a picture and, over it, their glare.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "glare/picture/picture.h"
#include "glare/scene/lamp_light.h"
#include "glare/scene/point_glare.h"

namespace glare {

/// A lamp in the viewer's field.
struct Headlamp {
  std::shared_ptr<const LuminousIntensityDistribution> intensity;
  LampPose pose;
  double dimming = 1;  ///< 0 or more.
  GlareKernel kernel;  ///< For the frame's camera and colour space.
};

/// Each lamp's light at the eye. Throws as `light_at_eye`.
std::vector<LightAtEye> lights_at_eye(std::span<const Headlamp> lamps,
                                      const Vector3& line_of_sight = {0, 0, 1});

/// One frame: `result` becomes the background, in cd/m^2, with the veil of every lamp added at its
/// place, by its light at the eye. What `result` was is lost; its memory is used again where it has
/// the background's size, so that a sequence's frames allocate nothing. Returns the lights. Throws
/// as `light_at_eye` and `add_glare`.
std::vector<LightAtEye> make_headlamp_frame(const Picture& background, const Camera& camera,
                                            std::span<const Headlamp> lamps, Picture& result,
                                            int threads = 0);

}  // namespace glare
