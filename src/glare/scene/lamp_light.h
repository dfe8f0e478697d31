// What of a lamp's light reaches the viewer's eye.
#pragma once

#include "glare/color/matrix.h"
#include "glare/photometry/luminous_intensity.h"

namespace glare {

/// Where a lamp is and how it stands, in the viewer's axes (right, up, forward).
struct LampPose {
  Vector3 position_m{0, 0, 10};
  /// From the direction of an oncoming car's lamps: against the viewer's forward axis, so that the
  /// vehicle's right is the viewer's left. Yaw, pitch and roll are the vehicle's: of an oncoming
  /// car, yaw to its right turns the lamp to the viewer's left.
  Mounting mounting;
};

/// The lamp's light at the eye, which is at the origin.
struct LightAtEye {
  Vector3 direction{0, 0, 1};  ///< The unit vector from the eye to the lamp, in the viewer's axes.
  double distance_m = 0;
  double horizontal_deg = 0;   ///< H of the eye as seen from the lamp, in the lamp's own axes,
  double vertical_deg = 0;     ///< and V.
  double intensity_cd = 0;     ///< Towards the eye.
  double illuminance_lux = 0;  ///< At the eye, on a plane across the line of sight.
};

/// The direction from the lamp to the eye in the axes (right, up, forward) of the vehicle that
/// carries the lamp and faces the viewer; of any length but 0.
Vector3 eye_in_vehicle_axes(const Vector3& lamp_position_m);

/// E = I cos(theta) / d^2 in lux, theta the angle between the lamp and the line of sight (of any
/// length but 0); 0 where theta is 90 degrees or more.
double illuminance_at_eye_lux(double intensity_cd, const Vector3& lamp_position_m,
                              const Vector3& line_of_sight = {0, 0, 1});

/// The light of a lamp with `distribution`, times `dimming` (0 or more). Throws `OptionError` for a
/// lamp in the eye's place (nearer than 1 mm), and numbers that aren't finite or are out of range.
LightAtEye light_at_eye(const LuminousIntensityDistribution& distribution, const LampPose& pose,
                        double dimming = 1, const Vector3& line_of_sight = {0, 0, 1});

}  // namespace glare
