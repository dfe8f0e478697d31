// The check picture: what was found, drawn over the photograph.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "glare/io/eye_photo.h"
#include "glare/io/photo/curve.h"

namespace glare {

namespace {

using photo::Place;
using Color = std::array<float, 3>;

/// Draws over what is there: `share` 1 hides it.
void blend(Color& pixel, const Color& color, float share) {
  for (std::size_t k = 0; k < 3; ++k) pixel[k] += share * (color[k] - pixel[k]);
}

/// A closed line, about 1.4 pixels wide.
void draw_closed_line(RgbImage& picture, const std::vector<Place>& points, const Color& color) {
  Image<float> shares(picture.width(), picture.height());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Place &from = points[i], &to = points[(i + 1) % points.size()];
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const int steps = std::max(1, static_cast<int>(std::min(4 * length, 1e5)));
    for (int step = 0; step < steps; ++step) {
      const double t = static_cast<double>(step) / steps;
      const double x = from[0] + t * (to[0] - from[0]), y = from[1] + t * (to[1] - from[1]);
      const double left = std::floor(x), top = std::floor(y);
      for (const double row : {top, top + 1})
        for (const double column : {left, left + 1}) {
          if (!(column >= 0 && row >= 0 && column < picture.width() && row < picture.height()))
            continue;
          float& share = shares(static_cast<int>(column), static_cast<int>(row));
          const double distance = std::hypot(column - x, row - y);
          share = std::max(share, static_cast<float>(std::clamp(1.2 - distance, 0.0, 1.0)));
        }
    }
  }
  for (std::size_t i = 0; i < shares.values().size(); ++i)
    blend(picture.values()[i], color, shares.values()[i]);
}

std::vector<Place> ellipse(const Place& center, const Place& axes, double angle_deg) {
  std::vector<Place> points;
  const double turn = angle_deg * std::numbers::pi / 180;
  for (int k = 0; k < 360; ++k) {
    const double t = 2 * std::numbers::pi * k / 360;
    const double u = 0.5 * axes[0] * std::cos(t), v = 0.5 * axes[1] * std::sin(t);
    points.push_back({center[0] + u * std::cos(turn) - v * std::sin(turn),
                      center[1] + u * std::sin(turn) + v * std::cos(turn)});
  }
  return points;
}

std::vector<Place> window(const EyePhoto& eye) {
  const double half = 0.5 * eye.pupil.width_mm / eye.mm_per_px;
  const Place& c = eye.pupil_center_px;
  return {{c[0] - half, c[1] - half},
          {c[0] + half, c[1] - half},
          {c[0] + half, c[1] + half},
          {c[0] - half, c[1] + half}};
}

}  // namespace

RgbImage check_picture(const RgbImage& photograph, const EyePhoto& eye) {
  RgbImage picture = photograph;
  for (std::size_t i = 0; i < picture.values().size(); ++i) {
    Color& p = picture.values()[i];
    const float grey = 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
    p = {grey, grey, grey};
    blend(p, {1, 0.1f, 0.1f}, 0.8f * (1 - eye.hairs.values()[i]));
  }
  draw_closed_line(picture, window(eye), {1, 1, 1});
  if (eye.iris_diameter_px > 0)
    draw_closed_line(picture,
                     ellipse(eye.iris_center_px, {eye.iris_diameter_px, eye.iris_diameter_px}, 0),
                     {0.2f, 0.5f, 1});
  draw_closed_line(picture, ellipse(eye.pupil_center_px, eye.pupil_axes_px, eye.pupil_angle_deg),
                   {1, 0.9f, 0});
  draw_closed_line(picture, photo::smooth_closed_curve(eye.outline_px, 2), {0.1f, 1, 0.2f});
  return picture;
}

}  // namespace glare
