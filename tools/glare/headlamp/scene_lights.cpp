#include "headlamp/scene_lights.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "glare/base/error.h"
#include "glare/io/photometry_file.h"
#include "glare/io/sha256.h"
#include "glare/scene/disability_glare.h"

namespace glare::tool {

namespace {

double distance_m(const LampPose& pose) {
  return std::hypot(pose.position_m[0], pose.position_m[1], pose.position_m[2]);
}

/// The light of a lamp that is as strong in every direction.
LightAtEye constant_light(double intensity_cd, const LampPose& pose, const Vector3& line_of_sight) {
  LightAtEye light;
  light.distance_m = distance_m(pose);
  for (std::size_t k = 0; k < 3; ++k) light.direction[k] = pose.position_m[k] / light.distance_m;
  const auto [horizontal, vertical] =
      horizontal_vertical_deg(in_lamp_axes(eye_in_vehicle_axes(pose.position_m), pose.mounting));
  light.horizontal_deg = horizontal;
  light.vertical_deg = vertical;
  light.intensity_cd = intensity_cd;
  light.illuminance_lux = illuminance_at_eye_lux(intensity_cd, pose.position_m, line_of_sight);
  return light;
}

/// What a lamp's file has. A range that the scene doesn't tell, or tells wrongly, is its mistake.
LuminousIntensityDistribution intensity_of(const SceneLamp& lamp, std::uint64_t memory_limit_bytes,
                                           const Console& console) {
  ReadPhotometryOptions options;
  options.image_h_deg = lamp.horizontal_deg;
  options.image_v_deg = lamp.vertical_deg;
  options.image_white_cd = lamp.white_cd;
  options.lamp_set = lamp.lamp_set;
  options.memory_limit_bytes = memory_limit_bytes;
  try {
    PhotometricData data = read_photometry(lamp.intensity, options);
    for (const std::string& warning : data.info.warnings)
      console.warn(lamp.intensity.string() + ": " + warning);
    return std::move(data.distribution);
  } catch (const OptionError& error) {
    throw InputError(lamp.place, error.what());
  } catch (const InputError& error) {
    throw InputError(lamp.place, error.what());
  }
}

std::string sha256_of_values(const LuminousIntensityDistribution& distribution) {
  std::string all = sha256_of(std::as_bytes(std::span(distribution.horizontal_deg()))) +
                    sha256_of(std::as_bytes(std::span(distribution.vertical_deg()))) +
                    sha256_of(std::as_bytes(distribution.candela().values())) +
                    std::to_string(static_cast<int>(distribution.type()));
  return sha256_of(std::as_bytes(std::span(all.data(), all.size())));
}

}  // namespace

SceneLights::SceneLights(const Scene& scene, std::uint64_t memory_limit_bytes,
                         const Console& console)
    : scene_(scene) {
  for (const SceneLamp& lamp : scene.lamps)
    distributions_.push_back(lamp.intensity.empty()
                                 ? std::nullopt
                                 : std::optional(intensity_of(lamp, memory_limit_bytes, console)));
  for (const auto& distribution : distributions_)
    sha256_.push_back(distribution ? sha256_of_values(*distribution) : "");
}

SceneLight SceneLights::light(std::size_t index, const Camera& camera,
                              const SceneFrame& frame) const {
  const SceneLamp& lamp = scene_.lamps[index];
  const Vector3& line_of_sight = scene_.viewer.line_of_sight;
  const LampPose pose = pose_of(scene_, index, camera, frame);
  constexpr double kNearest_m = 0.001;
  if (distance_m(pose) < kNearest_m)
    throw InputError(lamp.place, "lamp '" + lamp.name + "' is in the eye's place in frame " +
                                     std::to_string(frame.index + 1));
  SceneLight light;
  light.at_eye = distributions_[index]
                     ? light_at_eye(*distributions_[index], pose, lamp.flux_factor, line_of_sight)
                     : constant_light(lamp.intensity_cd * lamp.flux_factor, pose, line_of_sight);
  light.off_axis_deg = angle_between_deg(pose.position_m, line_of_sight);
  light.pixel = camera.pixel_of(pose.position_m);
  light.relative_luminance =
      lamp.relative_luminance.value_or(light.at_eye.intensity_cd / scene_.reference_intensity_cd);
  return light;
}

}  // namespace glare::tool
