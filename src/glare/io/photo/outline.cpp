#include "glare/io/photo/outline.h"

#include <algorithm>
#include <cmath>

namespace glare::photo {

namespace {

using Ratios = std::array<double, kEdgePoints>;

std::size_t around(int k) {
  return static_cast<std::size_t>((k % kEdgePoints + kEdgePoints) % kEdgePoints);
}

/// Where the dark part ends on a ray whose end is bright up to the ellipse; 1 on any other ray.
double dark_part(const Picture& picture, const PupilEllipse& pupil, double direction_rad,
                 double level) {
  const cv::Point2d ray = pupil.point_at(direction_rad) - pupil.center;
  constexpr double kPace = 0.01;
  double end = 1;
  for (double ratio = 0.97; ratio > 0; ratio -= kPace) {
    const cv::Point2d at = pupil.center + ratio * ray;
    const float value = sample(picture.smooth, at.x, at.y);
    if (value >= 0 && value < level) break;
    end = ratio;
  }
  return end;
}

/// Keeps what is below 0.93 where it does so on a run of rays wide enough for a lid.
void keep_lids_only(Ratios& dark) {
  constexpr int kNarrowest = 40;
  constexpr double kCut = 0.93;
  Ratios kept;
  kept.fill(1);
  for (int start = 0; start < kEdgePoints; ++start) {
    if (dark[around(start)] >= kCut || dark[around(start - 1)] < kCut) continue;
    int length = 0;
    while (length < kEdgePoints && dark[around(start + length)] < kCut) ++length;
    if (length < kNarrowest) continue;
    // The lid's edge goes on to the ellipse, at a small angle to it.
    for (int k = -20; k < length + 20; ++k) kept[around(start + k)] = dark[around(start + k)];
  }
  dark = kept;
}

Ratios lid_cuts(const Picture& picture, const PupilEllipse& pupil, double level) {
  Ratios dark;
  for (int k = 0; k < kEdgePoints; ++k)
    dark[around(k)] = dark_part(picture, pupil, 2 * CV_PI * k / kEdgePoints, level);
  keep_lids_only(dark);
  return dark;
}

Ratios calmed(const Ratios& ratios) {
  Ratios median, mean;
  for (int k = 0; k < kEdgePoints; ++k) {
    std::array<double, 7> near;
    for (int i = -3; i <= 3; ++i) near[static_cast<std::size_t>(i + 3)] = ratios[around(k + i)];
    std::nth_element(near.begin(), near.begin() + 3, near.end());
    median[around(k)] = near[3];
  }
  constexpr std::array<double, 3> kWeights = {0.4, 0.2, 0.1};
  for (int k = 0; k < kEdgePoints; ++k) {
    mean[around(k)] = kWeights[0] * median[around(k)];
    for (int i = 1; i <= 2; ++i)
      mean[around(k)] +=
          kWeights[static_cast<std::size_t>(i)] * (median[around(k - i)] + median[around(k + i)]);
  }
  return mean;
}

}  // namespace

Ratios pupil_outline(const Picture& picture, const PupilEllipse& pupil, double inside,
                     double contrast) {
  constexpr double kReach = 0.1;
  const Ratios lids = lid_cuts(picture, pupil, inside + 0.5 * contrast);
  const std::vector<EdgePoint> edge = edge_points(picture, pupil, kReach);
  const double clear = std::max<double>(picture.noise, 0.4 * contrast);
  Ratios ratios;
  for (int k = 0; k < kEdgePoints; ++k) {
    const EdgePoint& point = edge[around(k)];
    const bool seen = point.step >= clear && std::abs(point.ratio - 1) < 0.95 * kReach;
    ratios[around(k)] = lids[around(k)] < 1 ? lids[around(k)] : seen ? point.ratio : 1;
  }
  return calmed(ratios);
}

}  // namespace glare::photo
