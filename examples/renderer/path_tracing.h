// Light that comes along a ray, by tracing its paths backwards.
#pragma once

#include <cstdint>

#include "scene.h"

namespace renderer {

/// Numbers from 0 to below 1, the same on every machine (O'Neill's PCG, XSH-RR 64/32).
class Random {
 public:
  explicit Random(std::uint64_t stream) : state_(stream * 0x9E3779B97F4A7C15u + 1) {
    next(), next();
  }
  double next();

 private:
  std::uint64_t state_;
};

/// The luminance along a ray, cd/m^2: one random sample, whose mean over many is the scene's.
/// Bulbs light diffuse surfaces straight (a ray to a random place on each) and by what walls and
/// floor send on; they are seen in mirrors, glossy coats and through glass. What glass and mirrors
/// gather onto diffuse surfaces (caustics) is left out.
Vec3 traced_luminance(const Scene& scene, const Ray& ray, Random& random);

}  // namespace renderer
