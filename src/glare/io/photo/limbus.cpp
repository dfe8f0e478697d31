#include "glare/io/photo/limbus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace glare::photo {

namespace {

constexpr int kRays = 24;  // On each side.

struct Side {
  float step = 0;
  double agreement = 0;
  bool seen = false;
};

/// `sign`: 1 is right, -1 left. Rays from 30 degrees above the horizontal to 50 below.
Side side_of(const Picture& p, cv::Point2d center, double radius, double sign,
             std::vector<float>& steps) {
  constexpr double kHalf = 0.07;
  steps.clear();
  for (int k = 0; k < kRays; ++k) {
    const double angle = (-30 + 80.0 * k / (kRays - 1)) * std::numbers::pi / 180;
    const cv::Point2d ray = {sign * std::cos(angle), std::sin(angle)};
    const cv::Point2d in = center + radius * (1 - kHalf) * ray;
    const cv::Point2d out = center + radius * (1 + kHalf) * ray;
    const float inner = sample(p.smooth, in.x, in.y), outer = sample(p.smooth, out.x, out.y);
    if (inner >= 0 && outer >= 0) steps.push_back(outer - inner);
  }
  Side side;
  side.seen = steps.size() >= kRays / 2;
  if (!side.seen) return side;
  side.step = quantile(steps, 0.4);
  const float half = 0.5f * side.step;
  side.agreement = static_cast<double>(std::count_if(steps.begin(), steps.end(),
                                                     [&](float step) { return step > half; })) /
                   static_cast<double>(steps.size());
  return side;
}

Limbus measured(const Picture& p, cv::Point2d center, double radius, std::vector<float>& steps) {
  const Side left = side_of(p, center, radius, -1, steps);
  const Side right = side_of(p, center, radius, 1, steps);
  Limbus limbus{center, radius, 0, 0, left.seen && right.seen};
  if (limbus.both_sides) {
    limbus.contrast =
        std::min(left.step, right.step) + 0.25 * std::max(0.0f, std::abs(left.step - right.step));
    if (std::min(left.step, right.step) <= 0) limbus.contrast = 0;
    limbus.agreement = std::min(left.agreement, right.agreement);
  } else if (left.seen || right.seen) {
    const Side& side = left.seen ? left : right;
    limbus.contrast = 0.6 * side.step;
    limbus.agreement = 0.7 * side.agreement;
  }
  return limbus;
}

double merit(const Limbus& limbus) {
  return limbus.contrast * std::max(0.0, limbus.agreement - 0.3);
}

}  // namespace

std::optional<Limbus> found_limbus(const Picture& picture, const PupilEllipse& pupil) {
  Limbus best;
  std::vector<float> steps;
  for (double ratio = 1.25; ratio <= 6; ratio *= 1.03) {
    const double radius = ratio * pupil.a;
    const double room = std::min(0.14 * radius, 0.6 * (radius - pupil.a));
    for (int j = -2; j <= 2; ++j)
      for (int i = -3; i <= 3; ++i) {
        const cv::Point2d center = pupil.center + cv::Point2d(i * room / 3, j * room / 2);
        const Limbus limbus = measured(picture, center, radius, steps);
        if (merit(limbus) > merit(best)) best = limbus;
      }
  }
  if (best.radius <= 0 || best.contrast < picture.noise) return std::nullopt;
  return best;
}

}  // namespace glare::photo
