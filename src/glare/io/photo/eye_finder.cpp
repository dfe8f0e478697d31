#include "glare/io/photo/eye_finder.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "glare/io/photo/candidates.h"
#include "glare/io/photo/pupil_edge.h"

namespace glare::photo {

namespace {

constexpr std::size_t kCandidates = 24;
constexpr double kSearchWidth_px = 320;
/// Of the edge, seen: less may be a part of the pupil's and of a glint's.
constexpr double kWhole = 0.72;

bool contains(const PupilEllipse& e, cv::Point2d place) {
  const cv::Point2d from = place - e.center;
  return cv::norm(from) <= e.radius_at(std::atan2(from.y, from.x));
}

/// `inner` is the pupil of the iris that `outer` is, or of a part of it.
bool is_within(const PupilEllipse& inner, const PupilEllipse& outer) {
  return inner.mean_radius() < 0.85 * outer.mean_radius() &&
         cv::norm(inner.center - outer.center) < 0.35 * outer.mean_radius();
}

std::vector<SeenPupil> seen_pupils(const Picture& picture,
                                   const std::optional<cv::Point2d>& pupil_at) {
  const double factor =
      std::max(1.0, std::max(picture.width(), picture.height()) / kSearchWidth_px);
  const Picture small = reduced(picture, factor);
  std::vector<SeenPupil> seen;
  for (Circle circle : pupil_candidates(small, kCandidates)) {
    circle.center = factor * (circle.center + cv::Point2d(0.5, 0.5)) - cv::Point2d(0.5, 0.5);
    circle.radius *= factor;
    if (pupil_at && cv::norm(*pupil_at - circle.center) > 1.3 * circle.radius) continue;
    // The shorter reach finds a faint edge near to a strong one, such as the limbus.
    for (const double reach : {0.45, 0.22}) {
      const auto ellipse = fitted_pupil(picture, circle, reach);
      if (!ellipse || (pupil_at && !contains(*ellipse, *pupil_at))) continue;
      const Evidence evidence = evidence_for(picture, *ellipse);
      seen.push_back({*ellipse, evidence, confidence(evidence, *ellipse, pupil_at.has_value())});
    }
  }
  std::stable_sort(seen.begin(), seen.end(), [](const SeenPupil& a, const SeenPupil& b) {
    return a.confidence * a.evidence.support > b.confidence * b.evidence.support;
  });
  return seen;
}

}  // namespace

std::optional<SeenPupil> likeliest_pupil(const Picture& picture,
                                         const std::optional<cv::Point2d>& pupil_at) {
  const std::vector<SeenPupil> seen = seen_pupils(picture, pupil_at);
  if (seen.empty()) return std::nullopt;
  SeenPupil best = seen.front();
  for (const SeenPupil& other : seen)
    if (other.confidence >= kLeastConfidence && is_within(other.ellipse, best.ellipse) &&
        other.evidence.support >= kWhole && other.evidence.inside <= best.evidence.inside)
      best = other;
  return best;
}

}  // namespace glare::photo
