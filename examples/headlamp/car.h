// The model of a car: its own axes are (right, up, forward), in metres, from the road under the
// middle of its front axle.
#pragma once

#include "shapes.h"

namespace headlamp {

enum class Part { paint, windscreen, side_window, lamp, grille, plastic, chrome, plate, tyre, rim };

/// The distance to the car, negative inside; never above the true one by much, so that a ray may
/// be marched with it.
double car_distance(Vec3 p);

/// What the car is made of at a place on its surface, of an outward normal.
Part car_part(Vec3 p, Vec3 normal);

/// Whether a place on a rim is on a spoke, not between two.
bool on_spoke(Vec3 p);

/// The outward normal at a place on its surface.
Vec3 car_normal(Vec3 p);

/// A box that holds the car.
inline constexpr Vec3 kCarLow{-1.15, 0, -3.6}, kCarHigh{1.15, 1.55, 0.95};

/// The inner and the outer light of the right headlamp, seen from ahead: (right, up). The inner one
/// is the high beam's.
inline constexpr Vec2 kHighBeam{0.595, 0.655}, kLowBeam{0.745, 0.685};

/// The place on the car's front at (right, up).
Vec3 place_on_front(Vec2 right_up);

}  // namespace headlamp
