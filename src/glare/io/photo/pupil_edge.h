// The pupil's edge. Internal; of the module glare_eye_photo.
#pragma once

#include <optional>
#include <vector>

#include "glare/io/photo/candidates.h"
#include "glare/io/photo/picture.h"

namespace glare::photo {

/// What is seen on the ray from the centre at one direction, in units of the ellipse's radius.
struct EdgePoint {
  double direction_rad = 0;
  double ratio = 1;  ///< Where the grey values rise most, near 1.
  float step = 0;    ///< How much they rise there; negative: not seen (outside, or a glint).
};

inline constexpr int kEdgePoints = 360;

/// The rise of the grey values nearest to the ellipse on each of `kEdgePoints` rays, between
/// `1 - reach` and `1 + reach` of its radius.
std::vector<EdgePoint> edge_points(const Picture& picture, const PupilEllipse& ellipse,
                                   double reach);

/// The ellipse on which most of the edge lies: random sample consensus (M. Fischler and R. Bolles,
/// 1981) on the strongest edges, starting
/// from a circle, whose radius may be wrong by a share of `reach`, so that the straight edge of a
/// lid, lashes and glints have no weight. Nothing where there is none, or one flatter than 0.6.
std::optional<PupilEllipse> fitted_pupil(const Picture& picture, const Circle& start, double reach);

}  // namespace glare::photo
