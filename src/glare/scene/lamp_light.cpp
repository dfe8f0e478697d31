#include "glare/scene/lamp_light.h"

#include <algorithm>
#include <limits>

#include "glare/base/range_check.h"
#include "glare/scene/vector3.h"

namespace glare {

namespace {

constexpr double kNearestLamp_m = 0.001;

void require_valid(const Vector3& position_m, const Vector3& line_of_sight) {
  if (!is_finite(position_m)) throw OptionError("a lamp's position has a number that isn't finite");
  if (!(length(position_m) >= kNearestLamp_m))
    throw OptionError("a lamp is at the viewer's eye, expected at least 1 mm from it");
  if (!is_finite(line_of_sight) || length(line_of_sight) == 0)
    throw OptionError("the line of sight has no direction");
}

}  // namespace

Vector3 eye_in_vehicle_axes(const Vector3& lamp_position_m) {
  // The way to the eye is -position; the vehicle's right and forward are against the viewer's.
  return {lamp_position_m[0], -lamp_position_m[1], lamp_position_m[2]};
}

double illuminance_at_eye_lux(double intensity_cd, const Vector3& lamp_position_m,
                              const Vector3& line_of_sight) {
  const double along = dot(lamp_position_m, line_of_sight) / length(line_of_sight);
  const double square_m2 = dot(lamp_position_m, lamp_position_m);
  return intensity_cd * (std::max(0.0, along) / std::sqrt(square_m2)) / square_m2;
}

LightAtEye light_at_eye(const LuminousIntensityDistribution& distribution, const LampPose& pose,
                        double dimming, const Vector3& line_of_sight) {
  require_valid(pose.position_m, line_of_sight);
  require_in_range("a lamp's dimming", dimming, 0, std::numeric_limits<double>::max());
  const Vector3 to_eye = eye_in_vehicle_axes(pose.position_m);
  const auto [h, v] = horizontal_vertical_deg(in_lamp_axes(to_eye, pose.mounting));
  const double intensity_cd = dimming * distribution.towards(to_eye, pose.mounting);
  return {unit(pose.position_m),
          length(pose.position_m),
          h,
          v,
          intensity_cd,
          illuminance_at_eye_lux(intensity_cd, pose.position_m, line_of_sight)};
}

}  // namespace glare
