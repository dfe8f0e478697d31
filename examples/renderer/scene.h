// What is rendered: a terrace at night, lit by bulbs of several kinds of lamp. Axes are (right, up,
// ahead), in metres. Colours are linear, with BT.2020's primaries, which hold every lamp's colour:
// reflectances, and luminances in cd/m^2.
#pragma once

#include <glare/glare.h>

#include <optional>
#include <string>
#include <vector>

#include "shapes.h"

namespace renderer {

struct Material {
  enum class Kind { diffuse, glossy, mirror, glass } kind = Kind::diffuse;
  Vec3 reflectance;               ///< Of diffuse light; of a mirror at normal incidence.
  double refractive_index = 1.5;  ///< Of glass, and of a glossy coat.
};

struct Ball {
  Sphere shape;
  Material material;
};

/// A frosted bulb: a sphere as bright from everywhere.
struct Bulb {
  Sphere shape;
  Vec3 luminance;  ///< cd/m^2, in the colour of its lamp's spectrum.
};

/// What a ray meets first.
struct Hit {
  double distance = 0;
  Vec3 place, normal;
  Material material;
  const Bulb* bulb = nullptr;  ///< If it is one.
};

/// BT.2020's primaries and white, scene-linear.
glare::RgbColorSpace working_space();

class Scene {
 public:
  /// At a time from 0 to 1, in which the brightest bulb moves on its way behind the balls.
  explicit Scene(double time);

  std::optional<Hit> first_hit(const Ray& ray) const;
  /// Nothing is between a place and another at a distance, but for bulbs.
  bool is_free(const Ray& ray, double distance) const;
  /// From where there is nothing, cd/m^2.
  Vec3 sky_luminance(Vec3 direction) const;
  const std::vector<Bulb>& bulbs() const { return bulbs_; }

 private:
  void add_bulb(const std::string& lamp, double flux_lm, double radius_m, Vec3 center);
  Material floor_at(Vec3 place) const;

  std::vector<Ball> balls_;
  std::vector<Bulb> bulbs_;
  Plane floor_{{0, 1, 0}, 0}, wall_{{0, 0, -1}, -7.5};
};

}  // namespace renderer
