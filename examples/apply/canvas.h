// What the scenes share: a camera, a picture in cd/m^2 of linear BT.709, and smooth noise.
#pragma once

#include <glare/glare.h>

#include <functional>
#include <string>

#include "../vectors.h"

namespace scenes {

using vectors::Vec3;

/// Axes are (right, up, ahead), in metres. A pinhole that looks ahead, or `tilt_deg` upwards.
struct Camera {
  Vec3 place;
  double fov_deg = 30;  ///< From left to right.
  double tilt_deg = 0;
  int width = 960, height = 540;

  double focal_length_px() const;
  Vec3 direction(double column, double row) const;
};

struct Scene {
  Camera camera;
  /// The luminance of a direction; called from several threads.
  std::function<Vec3(Vec3 direction)> luminance;
  /// Lamps, too small for the rays above: discs, added by the share of each pixel that they fill.
  struct Lamp {
    Vec3 place;
    double radius_m = 0.01;
    Vec3 luminance;
  };
  std::vector<Lamp> lamps;
};

/// Each pixel the mean of `samples` x `samples` directions, and the lamps.
glare::Picture drawn(const Scene& scene, int samples);

/// Noise from 0 to 1 with one bump per unit, and the sum of several finer and finer ones.
double noise(double x, double y);
double fractal_noise(double x, double y);
/// From 0 to 1, another one for each number.
double hashed(int a, int b);

Scene night_street();
Scene sun_glint();
Scene christmas_tree();

}  // namespace scenes
