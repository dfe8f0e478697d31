#include "glare/io/built_in_color_spaces.h"

#include <array>

namespace glare {

namespace {

using Primaries = std::array<Chromaticity, 3>;  // Of red, green, blue.

constexpr Primaries kAp0 = {{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}}};

// ITU-R BT.709-6, item 1.4; ITU-R BT.2020-2, table 3; SMPTE EG 432-1.
Xyz d65() { return xyz_from_chromaticity({0.3127, 0.3290}); }

// SMPTE ST 2065-1 and Academy S-2014-004 give this white for both ACES spaces.
Xyz aces_white() { return xyz_from_chromaticity({0.32168, 0.33767}); }

// CIE illuminant C as in Kakimoto et al. 2010, whose printed matrix it reproduces to every decimal.
constexpr Xyz kKakimotoWhite = {0.9804, 1, 1.1812};

// SMPTE ST 2065-1.
RgbColorSpace aces2065_1() { return {"aces2065-1", kAp0, aces_white()}; }

}  // namespace

const std::vector<RgbColorSpace>& built_in_color_spaces() {
  static const std::vector<RgbColorSpace> spaces = {
      xyz_color_space(),
      lin_rec709_color_space(),
      // ITU-R BT.2020-2.
      {"lin_rec2020", Primaries{{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}}}, d65()},
      // SMPTE RP 431-2 with a D65 white (SMPTE EG 432-1).
      {"lin_p3d65", Primaries{{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}}, d65()},
      // AP1 primaries (Academy S-2014-004).
      {"acescg", Primaries{{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}}}, aces_white()},
      aces2065_1(),
      // NTSC primaries of 1953 (FCC; ITU-R BT.470-6, system M).
      {"ntsc1953", Primaries{{{0.67, 0.33}, {0.21, 0.71}, {0.14, 0.08}}}, kKakimotoWhite},
  };
  return spaces;
}

Matrix3 aces_interchange_from_xyz() {
  const Matrix3 xyz_from_aces =
      bradford_adaptation(aces_white(), d65()) * aces2065_1().xyz_from_rgb();
  return inverse(xyz_from_aces);
}

}  // namespace glare
