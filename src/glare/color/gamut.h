// What to do with colours that lie outside an RGB space's gamut.
#pragma once

#include <array>

namespace glare {

/// `rgb` moved towards the grey of its own luminance, just as far as it takes for no channel to be
/// negative; the luminance stays the same. `luminance_weights` are those of the space's channels
/// and sum to 1. A colour of zero or negative luminance becomes black.
std::array<float, 3> desaturated_into_gamut(const std::array<float, 3>& rgb,
                                            const std::array<double, 3>& luminance_weights);

/// A colour of luminance 1 without negative channels, `unit_rgb`, brought to `luminance`, in [0,
/// 1]; where a channel would exceed 1, white, the colour moves towards grey just as far as it
/// takes.
std::array<float, 3> limited_to_white(const std::array<float, 3>& unit_rgb, double luminance);

}  // namespace glare
