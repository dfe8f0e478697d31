#include "glare/io/photo/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace glare::photo {

namespace {

constexpr int kRays = 32;
constexpr double kSmallest_px = 6, kStep = 1.12;

using Directions = std::array<cv::Point2d, kRays>;

Directions directions() {
  Directions result;
  for (int k = 0; k < kRays; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / kRays;
    result[static_cast<std::size_t>(k)] = {std::cos(angle), std::sin(angle)};
  }
  return result;
}

/// How much a circle is like a pupil's edge; 0 where too much of it is outside of the picture.
double likeness(const Picture& p, const Directions& rays, cv::Point2d center, double r,
                std::vector<float>& steps, std::vector<float>& inside) {
  const double d = std::max(1.5, 0.12 * r);
  steps.clear();
  inside.clear();
  for (const cv::Point2d& ray : rays) {
    const cv::Point2d out = center + (r + d) * ray, in = center + (r - d) * ray;
    const float outer = sample(p.smooth, out.x, out.y), inner = sample(p.smooth, in.x, in.y);
    if (inner < 0 || outer < 0) continue;
    steps.push_back(outer - inner);
    inside.push_back(inner);
    for (const double share : {0.3, 0.65}) {
      const cv::Point2d at = center + share * r * ray;
      inside.push_back(std::max(0.0f, sample(p.smooth, at.x, at.y)));
    }
  }
  if (steps.size() < 3 * kRays / 4) return 0;
  const float step = quantile(steps, 0.3);
  if (step < p.noise) return 0;
  const float spread = quantile(inside, 0.7) - quantile(inside, 0.1);
  return step / (p.noise + 0.5f * spread + 0.15f * quantile(inside, 0.4));
}

bool same_place(const Circle& a, const Circle& b) {
  const double larger = std::max(a.radius, b.radius), smaller = std::min(a.radius, b.radius);
  return cv::norm(a.center - b.center) < 0.5 * larger && larger < 1.35 * smaller;
}

}  // namespace

std::vector<Circle> pupil_candidates(const Picture& picture, std::size_t count) {
  const Directions rays = directions();
  const double largest = 0.4 * std::min(picture.width(), picture.height());
  std::vector<Circle> all;
  std::vector<float> steps, inside;
  for (double r = kSmallest_px; r <= largest; r *= kStep) {
    const double stride = std::max(1.5, r / 6);
    for (double y = 0; y < picture.height(); y += stride)
      for (double x = 0; x < picture.width(); x += stride) {
        const double score = likeness(picture, rays, {x, y}, r, steps, inside);
        if (score > 0.4) all.push_back({{x, y}, r, score});
      }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Circle& a, const Circle& b) { return a.score > b.score; });
  std::vector<Circle> best;
  for (const Circle& circle : all) {
    if (best.size() == count) break;
    if (std::none_of(best.begin(), best.end(),
                     [&](const Circle& other) { return same_place(circle, other); }))
      best.push_back(circle);
  }
  return best;
}

}  // namespace glare::photo
