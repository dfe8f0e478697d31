// A glare template seen in a picture: around a point of light, at its place and angular size.
#pragma once

#include <memory>
#include <span>

#include "glare/picture/picture.h"
#include "glare/scene/camera.h"
#include "glare/template/glare_template.h"

namespace glare {

/// A template made ready for a picture: its veil in cd/m^2 per lux at the eye, in the picture's
/// colour space, at about the picture's degrees per pixel (energy-conserving). Made once, used for
/// every frame and lamp; cheap to copy.
class GlareKernel {
 public:
  GlareKernel(const GlareTemplate& glare_template, const Camera& camera,
              const RgbColorSpace& picture_space);

 private:
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

/// A point of light in the viewer's field.
struct PointOfLight {
  Vector3 direction{0, 0, 1};  ///< Towards it: (right, up, forward), of any length but 0.
  double illuminance_lux = 0;  ///< At the eye; 0 or more.
  GlareKernel kernel;
};

/// Adds the veil of each point of light, E lux times the template per steradian, to a picture in
/// cd/m^2: each pixel gets the template's mean over the directions that it covers. Those directions
/// are exact for the perspective: the template lies about the point of light, in direction sines
/// about it.
void add_glare(Picture& picture_cd_per_m2, const Camera& camera,
               std::span<const PointOfLight> points, int threads = 0);

}  // namespace glare
