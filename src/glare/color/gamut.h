// What to do with colours that lie outside an RGB space's gamut.
#pragma once

#include <array>

namespace glare {

/// `rgb` moved towards the grey of its own luminance, just as far as it takes for no channel to be
/// negative; the luminance stays the same. `luminance_weights` are those of the space's channels
/// and sum to 1. A colour of zero or negative luminance becomes black.
std::array<float, 3> desaturated_into_gamut(const std::array<float, 3>& rgb,
                                            const std::array<double, 3>& luminance_weights);

}  // namespace glare
