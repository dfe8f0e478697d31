#include "glare/scene/headlamp_frame.h"

namespace glare {

std::vector<LightAtEye> lights_at_eye(std::span<const Headlamp> lamps,
                                      const Vector3& line_of_sight) {
  std::vector<LightAtEye> lights;
  for (const Headlamp& lamp : lamps)
    lights.push_back(light_at_eye(*lamp.intensity, lamp.pose, lamp.dimming, line_of_sight));
  return lights;
}

std::vector<LightAtEye> make_headlamp_frame(const Picture& background, const Camera& camera,
                                            std::span<const Headlamp> lamps, Picture& result,
                                            int threads) {
  std::vector<LightAtEye> lights = lights_at_eye(lamps);
  std::vector<PointOfLight> points;
  for (std::size_t i = 0; i < lamps.size(); ++i)
    points.push_back({lights[i].direction, lights[i].illuminance_lux, lamps[i].kernel});
  with_glare(background, camera, points, result, threads);
  return lights;
}

}  // namespace glare
