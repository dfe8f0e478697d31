// Hairs in front of the eye. Internal; of the module glare_eye_photo.
#pragma once

#include "glare/io/photo/picture.h"

namespace glare::photo {

/// What of the light gets past the hairs, from 0 to 1: dark lines up to `widest_px` wide, found as
/// the black top-hat (closing less picture) at that width of the denoised picture, and kept where
/// they are long and dark enough. 1 in and around the pupil, whose own dark hides hairs. A hair's
/// dark is `dark`, the pupil's grey value or that of the darkest hairs.
cv::Mat1f hair_transmittance(const Picture& picture, const PupilEllipse& pupil, double dark,
                             double widest_px);

}  // namespace glare::photo
