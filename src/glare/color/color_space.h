// Scene-linear RGB colour spaces: primaries, white, and the matrices between them and CIE XYZ.
#pragma once

#include <array>
#include <string>

#include "glare/color/matrix.h"

namespace glare {

/// CIE chromaticity coordinates x = X / (X + Y + Z), y = Y / (X + Y + Z).
struct Chromaticity {
  double x = 0;
  double y = 0;
};

/// NaN where X + Y + Z is 0.
Chromaticity chromaticity(const Xyz& xyz);

/// The colour of this chromaticity with luminance 1. `c.y` isn't 0.
Xyz xyz_from_chromaticity(const Chromaticity& c);

/// A space whose values are linear in light: RGB = rgb_from_xyz * XYZ, with no adaptation of
/// white. RGB (1, 1, 1) is the space's white at luminance 1.
class RgbColorSpace {
 public:
  /// From the chromaticities of red, green and blue, and the XYZ of white (scaled to Y = 1; SMPTE
  /// RP 177-1993). Throws `InputError` where the primaries lie on one line.
  RgbColorSpace(std::string name, const std::array<Chromaticity, 3>& primaries, const Xyz& white);

  /// From the matrix itself; primaries and white are read from its inverse.
  RgbColorSpace(std::string name, const Matrix3& rgb_from_xyz);

  const std::string& name() const { return name_; }
  const Matrix3& rgb_from_xyz() const { return rgb_from_xyz_; }
  const Matrix3& xyz_from_rgb() const { return xyz_from_rgb_; }

  /// The chromaticities that the matrix implies, so that a file's numbers agree with its pixels.
  std::array<Chromaticity, 3> primaries() const;
  Xyz white_xyz() const;

  /// True for CIE XYZ itself, whose channels are named X, Y, Z and which has no primaries.
  bool is_xyz() const;

 private:
  std::string name_;
  Matrix3 rgb_from_xyz_;
  Matrix3 xyz_from_rgb_;
};

/// CIE XYZ itself, under the name "xyz".
RgbColorSpace xyz_color_space();

/// Linear light with the primaries and white of ITU-R BT.709, "lin_rec709".
RgbColorSpace lin_rec709_color_space();

/// XYZ adapted from one white to another by the Bradford cone responses (linear, no degree of
/// adaptation; Lam 1985, as in ICC.1). Both whites have Y = 1 and positive cone responses, else
/// `InputError`.
Matrix3 bradford_adaptation(const Xyz& from_white, const Xyz& to_white);

}  // namespace glare
