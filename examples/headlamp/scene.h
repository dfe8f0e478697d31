// The car on the street, as a viewer sees it: how much light comes along a ray. Places and
// directions are (right, up, forward) of the viewer, in metres, from the road under its eye.
#pragma once

#include <optional>

#include "shapes.h"

namespace headlamp {

class Scene {
 public:
  /// The middle of the car's front axle is ahead of the viewer; at 0 degrees it drives towards the
  /// viewer, and a positive angle turns it to its own right.
  Scene(double distance_m, double yaw_deg);

  /// Where a ray meets the car.
  std::optional<Vec3> on_car(Vec3 origin, Vec3 direction) const;
  /// From a place on the car, cd/m^2, for a ray that came along the direction.
  Vec3 car_luminance(Vec3 place, Vec3 direction) const;
  /// From everything else: the car's shadow is on the road.
  Vec3 street_luminance(Vec3 origin, Vec3 direction) const;

  /// A place of the car's (right, up, forward) in the viewer's.
  Vec3 place_of(Vec3 on_car) const;

 private:
  Vec3 turned_to_car(Vec3 direction) const;
  Vec3 turned_to_viewer(Vec3 direction) const;
  Vec3 in_car(Vec3 place) const { return turned_to_car(place - Vec3{0, 0, distance_}); }
  Vec3 mirrored_luminance(Vec3 normal, Vec3 direction) const;

  double distance_, cosine_, sine_;
};

}  // namespace headlamp
