// The pupil's own outline. Internal; of the module glare_eye_photo.
#pragma once

#include <array>

#include "glare/io/photo/pupil_edge.h"

namespace glare::photo {

/// The outline's distances from the ellipse's centre, in units of the ellipse's radius, at
/// `kEdgePoints` directions from the x axis on, towards y. Where the edge is seen, it is followed;
/// where a lid cuts the pupil (a bright part of 40 degrees or more that reaches in), the lid's
/// edge; where a glint or a lack of contrast hides it, the ellipse.
std::array<double, kEdgePoints> pupil_outline(const Picture& picture, const PupilEllipse& pupil,
                                              double inside, double contrast);

}  // namespace glare::photo
