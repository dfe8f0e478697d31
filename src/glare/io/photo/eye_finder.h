// The eye in a photograph: the search from start to end. Internal; of the module glare_eye_photo.
#pragma once

#include <optional>
#include <string>

#include "glare/io/photo/judgement.h"

namespace glare::photo {

struct SeenPupil {
  PupilEllipse ellipse;
  Evidence evidence;
  double confidence = 0;
};

/// Below this nothing is reported.
inline constexpr double kLeastConfidence = 0.45;

/// The pupil of which most is sure; perhaps with a confidence too low to be reported. With
/// `pupil_at`, one that contains this place. Nothing where nothing is like a pupil.
std::optional<SeenPupil> likeliest_pupil(const Picture& picture,
                                         const std::optional<cv::Point2d>& pupil_at);

}  // namespace glare::photo
