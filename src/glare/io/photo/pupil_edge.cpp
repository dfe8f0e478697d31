#include "glare/io/photo/pupil_edge.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace glare::photo {

namespace {

constexpr double kFlattest = 0.6;
constexpr double kInlier = 0.035;  // Of the radius.

PupilEllipse from_box(const cv::RotatedRect& box) {
  PupilEllipse e{box.center, box.size.width / 2.0, box.size.height / 2.0,
                 box.angle * std::numbers::pi / 180};
  if (e.a < e.b) {
    std::swap(e.a, e.b);
    e.angle_rad += std::numbers::pi / 2;
  }
  e.angle_rad = std::remainder(e.angle_rad, std::numbers::pi);
  return e;
}

/// A pseudo-random number of at most 2^32 - 1 (after G. Steele and others, SplitMix, 2014).
std::uint32_t random_number(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9E3779B97F4A7C15u);
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return static_cast<std::uint32_t>((z ^ z >> 31) >> 32);
}

struct WeightedPoint {
  cv::Point2f place;
  double weight;
};

double distance_ratio(const PupilEllipse& e, const cv::Point2f& p) {
  const cv::Point2d from = cv::Point2d(p) - e.center;
  return cv::norm(from) / e.radius_at(std::atan2(from.y, from.x));
}

bool plausible(const PupilEllipse& e, const PupilEllipse& start) {
  const double growth = e.mean_radius() / start.mean_radius();
  return std::isfinite(growth) && e.b >= kFlattest * e.a && growth > 0.6 && growth < 1.6 &&
         cv::norm(e.center - start.center) < 0.6 * start.mean_radius();
}

double consensus(const PupilEllipse& e, const std::vector<WeightedPoint>& points) {
  double sum = 0;
  for (const WeightedPoint& p : points) {
    const double off = (distance_ratio(e, p.place) - 1) / kInlier;
    if (std::abs(off) < 1) sum += p.weight * (1 - off * off);
  }
  // A lid that cuts the pupil flattens an ellipse through all of the edge; few pupils are flat.
  return sum * e.b / e.a;
}

std::vector<WeightedPoint> strong_points(const std::vector<EdgePoint>& edge,
                                         const PupilEllipse& ellipse, float noise) {
  std::vector<float> steps;
  for (const EdgePoint& p : edge)
    if (p.step > 0) steps.push_back(p.step);
  const float usual = quantile(steps, 0.5);
  std::vector<WeightedPoint> points;
  for (std::size_t k = 0; k < edge.size(); k += 2) {
    const EdgePoint& p = edge[k];
    if (p.step < std::max(0.3f * usual, noise)) continue;
    const double r = p.ratio * ellipse.radius_at(p.direction_rad);
    points.push_back({cv::Point2d(ellipse.center.x + r * std::cos(p.direction_rad),
                                  ellipse.center.y + r * std::sin(p.direction_rad)),
                      std::min(1.0f, p.step / std::max(usual, 1e-6f))});
  }
  return points;
}

std::optional<PupilEllipse> fit_to(const std::vector<cv::Point2f>& points,
                                   const PupilEllipse& start) {
  if (points.size() < 6) return std::nullopt;
  const PupilEllipse e = from_box(cv::fitEllipseDirect(points));
  return plausible(e, start) ? std::optional(e) : std::nullopt;
}

std::optional<PupilEllipse> refit(const PupilEllipse& e, const std::vector<WeightedPoint>& points) {
  std::vector<cv::Point2f> inliers;
  for (const WeightedPoint& p : points)
    if (std::abs(distance_ratio(e, p.place) - 1) < kInlier) inliers.push_back(p.place);
  return fit_to(inliers, e);
}

std::optional<PupilEllipse> agreed_ellipse(const std::vector<WeightedPoint>& points,
                                           const PupilEllipse& start) {
  constexpr int kTrials = 120;
  if (points.size() < kEdgePoints / 10) return std::nullopt;
  std::uint64_t state = 1;
  std::optional<PupilEllipse> best;
  double most = 0;
  std::vector<cv::Point2f> few(7);
  for (int trial = 0; trial < kTrials; ++trial) {
    for (auto& p : few) p = points[std::uint64_t{random_number(state)} * points.size() >> 32].place;
    const auto e = fit_to(few, start);
    if (!e) continue;
    const double sum = consensus(*e, points);
    if (sum > most) {
      most = sum;
      best = e;
    }
  }
  for (int i = 0; best && i < 3; ++i) {
    const auto better = refit(*best, points);
    if (!better || consensus(*better, points) < most * 0.98) break;
    best = better;
  }
  return best;
}

}  // namespace

std::vector<EdgePoint> edge_points(const Picture& picture, const PupilEllipse& ellipse,
                                   double reach) {
  constexpr double kWidth = 0.06;  // Half of the distance over which a step is taken.
  std::vector<EdgePoint> edge(kEdgePoints);
  for (int k = 0; k < kEdgePoints; ++k) {
    EdgePoint& point = edge[static_cast<std::size_t>(k)];
    point.direction_rad = 2 * std::numbers::pi * k / kEdgePoints;
    const double r = ellipse.radius_at(point.direction_rad);
    const cv::Point2d along =
        r * cv::Point2d(std::cos(point.direction_rad), std::sin(point.direction_rad));
    const double half = std::max(kWidth, 1.2 / r), pace = std::min(0.02, 0.5 / r);
    float best = 0;
    double best_ratio = 1;
    point.step = -1;
    for (double ratio = 1 - reach; ratio <= 1 + reach; ratio += pace) {
      const cv::Point2d in = ellipse.center + (ratio - half) * along;
      const cv::Point2d out = ellipse.center + (ratio + half) * along;
      const float inner = sample(picture.smooth, in.x, in.y);
      const float outer = sample(picture.smooth, out.x, out.y);
      if (inner < 0 || outer < 0) continue;
      const double off = (ratio - 1) / reach;
      const float step = (outer - inner) * static_cast<float>(1 - 0.3 * off * off);
      if (point.step < 0) point.step = 0;
      if (step > best) {
        best = step;
        best_ratio = ratio;
      }
    }
    if (point.step < 0) continue;
    point.step = best;
    point.ratio = best_ratio;
    const cv::Point at = ellipse.center + best_ratio * along;
    if (picture.glints(std::clamp(at.y, 0, picture.height() - 1),
                       std::clamp(at.x, 0, picture.width() - 1)))
      point.step = -1;
  }
  return edge;
}

std::optional<PupilEllipse> fitted_pupil(const Picture& picture, const Circle& start,
                                         double reach) {
  PupilEllipse ellipse{start.center, start.radius, start.radius, 0};
  for (const double part : {1.0, 0.67, 0.45}) {
    const auto points =
        strong_points(edge_points(picture, ellipse, part * reach), ellipse, picture.noise);
    const auto better = agreed_ellipse(points, ellipse);
    if (!better) return std::nullopt;
    ellipse = *better;
  }
  return ellipse;
}

}  // namespace glare::photo
