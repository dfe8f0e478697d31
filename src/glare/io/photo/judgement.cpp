#include "glare/io/photo/judgement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glare/io/photo/pupil_edge.h"

namespace glare::photo {

namespace {

/// 0 up to `none`, 1 from `full` on, and smooth between.
double rising(double value, double none, double full) {
  const double t = std::clamp((value - none) / (full - none), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Grey values on rings at these shares of the ellipse's radius.
std::vector<float> ring_values(const Picture& p, const PupilEllipse& e, double first, double last) {
  std::vector<float> values;
  for (double share = first; share <= last + 1e-9; share += 0.1)
    for (int k = 0; k < 48; ++k) {
      const double angle = 2 * std::numbers::pi * k / 48;
      const cv::Point2d at = e.center + share * (e.point_at(angle) - e.center);
      const float value = sample(p.smooth, at.x, at.y);
      if (value >= 0) values.push_back(value);
    }
  return values;
}

void measure_edge(const Picture& picture, const PupilEllipse& pupil, Evidence& evidence) {
  const float clear = std::max(1.5f * picture.noise, 0.35f * static_cast<float>(evidence.contrast));
  int seen = 0, supported = 0;
  double squares = 0;
  for (const EdgePoint& point : edge_points(picture, pupil, 0.1)) {
    if (point.step < 0) continue;
    ++seen;
    if (point.step < clear || std::abs(point.ratio - 1) > 0.07) continue;
    ++supported;
    squares += (point.ratio - 1) * (point.ratio - 1);
  }
  if (seen < kEdgePoints / 3) return;
  evidence.support = static_cast<double>(supported) / seen;
  evidence.fit = supported > 0 ? std::sqrt(squares / supported) : 1;
}

/// Left, right and below: where no lid is.
double ring_evenness_of(const Picture& p, const PupilEllipse& e, const Limbus& limbus,
                        double contrast) {
  std::vector<float> values;
  for (int k = 0; k < 48; ++k) {
    const double angle = (-30 + 240.0 * k / 47) * std::numbers::pi / 180;
    const double inner = 1.15 * e.radius_at(angle), outer = 0.88 * limbus.radius;
    for (int i = 0; i < 5 && outer > inner; ++i) {
      const double r = inner + (outer - inner) * i / 4;
      const float value =
          sample(p.smooth, e.center.x + r * std::cos(angle), e.center.y + r * std::sin(angle));
      if (value >= 0) values.push_back(value);
    }
  }
  if (values.empty()) return 1.9;  // The ring is too narrow to tell.
  return contrast / (quantile(values, 0.75) - quantile(values, 0.2) + p.noise);
}

}  // namespace

Evidence evidence_for(const Picture& picture, const PupilEllipse& pupil) {
  Evidence evidence;
  std::vector<float> inside = ring_values(picture, pupil, 0.1, 0.8);
  std::vector<float> outside = ring_values(picture, pupil, 1.15, 1.35);
  const double spread = quantile(inside, 0.75) - quantile(inside, 0.1);
  evidence.inside = quantile(inside, 0.4);
  evidence.contrast = quantile(outside, 0.4) - evidence.inside;
  evidence.evenness = evidence.contrast / (spread + picture.noise);
  evidence.roundness = pupil.b / pupil.a;
  evidence.noise = picture.noise;
  measure_edge(picture, pupil, evidence);
  evidence.limbus = found_limbus(picture, pupil);
  if (evidence.limbus)
    evidence.ring_evenness = ring_evenness_of(picture, pupil, *evidence.limbus, evidence.contrast);
  return evidence;
}

double limbus_confidence(const Evidence& e, const PupilEllipse& pupil) {
  if (!e.limbus) return 0;
  const double ratio = pupil.mean_radius() / e.limbus->radius;
  return rising(e.limbus->contrast, 5 * e.noise, 17 * e.noise) *
         rising(e.limbus->agreement, 0.4, 0.75) * rising(ratio, 0.14, 0.2) *
         rising(e.ring_evenness, 1.1, 2.4);
}

double confidence(const Evidence& e, const PupilEllipse& pupil, bool chosen) {
  const double edge = rising(e.support, 0.35, 0.75) * rising(e.roundness, 0.58, 0.75) *
                      rising(0.06 - e.fit, 0, 0.03);
  const double dark = rising(e.contrast, 2 * e.noise, 6 * e.noise) * rising(e.evenness, 0.8, 2.5) *
                      rising(0.6 - e.inside, 0, 0.25);
  const double iris = rising(limbus_confidence(e, pupil), 0.35, 0.75);
  return std::cbrt(edge * dark * (chosen ? 0.5 + 0.5 * iris : iris));
}

}  // namespace glare::photo
