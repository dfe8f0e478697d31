// Beams of light as functions, measured as a photometer would.
#pragma once

#include <functional>
#include <vector>

#include "glare/photometry/luminous_intensity.h"

namespace glare::test {

/// Angles in equal steps, both ends among them.
std::vector<double> steps(double first, double last, int count);

/// A beam, candela as a function of the direction (right, up, forward), on a grid of angles.
LuminousIntensityDistribution sampled(PhotometricType type, const std::vector<double>& horizontal,
                                      const std::vector<double>& vertical,
                                      const std::function<double(const Vector3&)>& beam,
                                      bool gamma_zero_is_forward = false);

}  // namespace glare::test
