// A street at dusk, in cd/m^2 of linear BT.709: the sky, trees along the road, the road. Axes are
// (right, up, forward) of the viewer's, in metres; the road is at height 0.
#pragma once

#include "shapes.h"

namespace headlamp {

/// The luminance that comes from a direction, without what stands on the road. The origin matters
/// for what is near.
Vec3 street_luminance(Vec3 origin, Vec3 direction);

/// The same without what is small: what paint mirrors.
Vec3 surroundings_luminance(Vec3 direction);

/// On a surface of a normal, from sky and ground: lux by colour.
Vec3 dusk_illuminance(Vec3 normal);

}  // namespace headlamp
