// How sure it is that a dark ellipse is a pupil. Internal; of the module glare_eye_photo.
#pragma once

#include <optional>
#include <string>

#include "glare/io/photo/limbus.h"
#include "glare/io/photo/picture.h"

namespace glare::photo {

/// What speaks for a pupil.
struct Evidence {
  double support = 0;    ///< Share of the edge, without glints, with a clear step on the ellipse.
  double roundness = 0;  ///< b / a.
  double fit = 0;        ///< Root mean square distance of the seen edge, over the radius.
  double contrast = 0;   ///< Median grey value outside less that inside.
  double evenness = 0;   ///< Contrast over the spread inside.
  double inside = 0;     ///< Median grey value inside.
  double ring_evenness = 0;  ///< Contrast over the spread of the ring between pupil and limbus.
  double noise = 0;
  std::optional<Limbus> limbus;
};

Evidence evidence_for(const Picture& picture, const PupilEllipse& pupil);

/// From 0 to 1. `chosen`: a person says that the pupil is there.
double confidence(const Evidence& evidence, const PupilEllipse& pupil, bool chosen);

/// The same for the limbus, as far as it alone goes.
double limbus_confidence(const Evidence& evidence, const PupilEllipse& pupil);

}  // namespace glare::photo
