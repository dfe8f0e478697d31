// Where a pupil may be. Internal; of the module glare_eye_photo.
#pragma once

#include <vector>

#include "glare/io/photo/picture.h"

namespace glare::photo {

struct Circle {
  cv::Point2d center;
  double radius = 0;
  double score = 0;
};

/// The circles that are most like a pupil: dark and even within, brighter all around. The measure
/// is J. Daugman's integro-differential one (High confidence visual recognition of persons, 1993)
/// with a low quantile of the steps along the circle in place of their mean, so that a lid, lashes
/// and glints on less than a third of it don't count. The best first; at most `count`.
std::vector<Circle> pupil_candidates(const Picture& picture, std::size_t count);

}  // namespace glare::photo
