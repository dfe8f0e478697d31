// From scene-linear light to what a display shows.
#pragma once

#include <array>

namespace glare {

/// A sigmoid on luminance that keeps the colour: L becomes c^n / (c^n + 1) of the display's white,
/// with c = L / middle_luminance and n = 1 / compression (the form of Naka and Rushton, 1966, for
/// the response of photoreceptors).
struct SigmoidToneMap {
  double middle_luminance = 1;  ///< Comes out at half of the display's white; > 0.
  double compression = 1;       ///< 1 keeps the contrast around the middle; more flattens it; > 0.

  /// R, G, B in [0, 1], encoded for sRGB (IEC 61966-2-1), from linear light with the primaries of
  /// BT.709. A colour that the display can't show moves towards the grey of its luminance. Light of
  /// zero or negative luminance is black.
  std::array<float, 3> operator()(const std::array<float, 3>& lin_rec709) const;
};

}  // namespace glare
