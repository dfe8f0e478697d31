// A slow, obvious reference for the veil in a picture's pixel. It shares no code with the library.
#pragma once

#include <array>

#include "glare/scene/camera.h"
#include "glare/template/glare_template.h"

namespace glare::test {

/// How many places across a pixel, and how a template is read at one.
struct SlowVeil {
  int places = 24;
  /// 0: constant in each of the template's pixels. Else, the squares blend within this share of
  /// their width about each side; with 1, linearly from centre to centre.
  double softness = 0;
};

/// The mean over a pixel of the first channel of the template about a lamp, per lux, in the
/// template's own unit: by places spread evenly over the pixel.
double slow_veil(const GlareTemplate& glare_template, const Camera& camera,
                 const Vector3& lamp_direction, int column, int row, const SlowVeil& how = {});

/// The area of a picture's pixel in direction sines about the lamp, from its corners.
double sine_area(const Camera& camera, const Vector3& lamp_direction, int column, int row);

/// Direction sines (right, down) about the lamp of a place in the picture; by trigonometry.
std::array<double, 2> sines_about(const Camera& camera, const Vector3& lamp_direction,
                                  double column, double row);

}  // namespace glare::test
