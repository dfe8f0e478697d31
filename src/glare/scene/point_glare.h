// A glare template seen in a picture: around a point of light, at its place and angular size.
#pragma once

#include <memory>
#include <span>

#include "glare/picture/picture.h"
#include "glare/scene/camera.h"
#include "glare/template/glare_template.h"

namespace glare {

/// A template made ready for a picture: its veil in cd/m^2 per lux at the eye, in the picture's
/// colour space, at a pitch that the picture's pixels need (energy-conserving). Made once, used for
/// every frame and lamp; cheap to copy.
///
/// Where the template is finer than the picture, each of its pixels fills its square; where it is
/// coarser, squares blend into one another, with their light kept, so that they don't show. Beyond
/// its border a template says nothing, and nothing is added.
class GlareKernel {
 public:
  /// Throws `OptionError` for a camera out of range, `InputError` for a template without pixels,
  /// pitch or scale.
  GlareKernel(const GlareTemplate& glare_template, const Camera& camera,
              const RgbColorSpace& picture_space);

  struct Parts;
  const Parts& parts() const { return *parts_; }  ///< Internal.

 private:
  std::shared_ptr<const Parts> parts_;
};

/// A point of light in the viewer's field.
struct PointOfLight {
  Vector3 direction{0, 0, 1};  ///< Towards it: (right, up, forward), of any length but 0.
  double illuminance_lux = 0;  ///< At the eye; 0 or more.
  GlareKernel kernel;
};

/// Adds the veil of each point of light, E lux times the template per steradian, to a picture in
/// cd/m^2: each pixel gets the template's mean over the directions that it covers. The template
/// lies about the point of light, in direction sines about it: it is turned there from the viewer's
/// axis by the shortest way, and its right and down are the picture's. Those directions are exact
/// for the perspective. So the sum over pixels of what is added, times the area of each in
/// direction sines (which are taken for steradians, as in the template), is E times the captured
/// energy.
///
/// `camera` is the one that the kernels were made for. The same bytes for any number of threads
/// (0: as many as the machine has). Throws `OptionError` for a picture of another size than the
/// camera's, a kernel made for a finer one, a direction of no length, or an illuminance that is
/// negative or not finite.
void add_glare(Picture& picture_cd_per_m2, const Camera& camera,
               std::span<const PointOfLight> points, int threads = 0);

/// The same into another picture: `result` becomes `picture_cd_per_m2` with the veil. Its memory is
/// used again where it has the same size.
void with_glare(const Picture& picture_cd_per_m2, const Camera& camera,
                std::span<const PointOfLight> points, Picture& result, int threads = 0);

/// The illuminance at the eye, in lux, whose veil has `luminance` in cd/m^2 (or any unit that the
/// picture is in) at the brightest pixel of the template: for `L0 * template` where the lamp's
/// relative luminance L0 is known, and not its candelas. Throws `InputError` for a template
/// that is dark.
double illuminance_for_peak_lux(const GlareTemplate& glare_template, double luminance);

}  // namespace glare
