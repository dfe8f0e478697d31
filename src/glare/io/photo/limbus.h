// The iris' outer edge. Internal; of the module glare_eye_photo.
#pragma once

#include <optional>

#include "glare/io/photo/picture.h"

namespace glare::photo {

struct Limbus {
  cv::Point2d center;
  double radius = 0;
  double contrast = 0;   ///< Step of the grey values across it, the fainter of its two sides.
  double agreement = 0;  ///< Share of the rays on both sides where they rise by a half of that.
  bool both_sides = false;
};

/// The circle around the pupil, 1.25 to 6 times as wide and nearly concentric, across which the
/// grey values rise most on the left and on the right (the lids hide what is above and below).
std::optional<Limbus> found_limbus(const Picture& picture, const PupilEllipse& pupil);

}  // namespace glare::photo
