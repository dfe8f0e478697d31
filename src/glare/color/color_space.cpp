#include "glare/color/color_space.h"

#include <utility>

#include "glare/base/error.h"

namespace glare {

namespace {

Matrix3 xyz_from_rgb_matrix(const std::array<Chromaticity, 3>& primaries, const Xyz& white) {
  Matrix3 columns;
  for (int k = 0; k < 3; ++k) {
    if (primaries[k].y == 0) throw InputError("", "a primary has chromaticity y = 0");
    const Xyz primary = xyz_from_chromaticity(primaries[k]);
    for (int row = 0; row < 3; ++row) columns[row][k] = primary[row];
  }
  const Xyz unit_white = {white[0] / white[1], 1, white[2] / white[1]};
  return columns * diagonal_matrix(inverse(columns) * unit_white);
}

}  // namespace

Chromaticity chromaticity(const Xyz& xyz) {
  const double sum = xyz[0] + xyz[1] + xyz[2];
  return {xyz[0] / sum, xyz[1] / sum};
}

Xyz xyz_from_chromaticity(const Chromaticity& c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

RgbColorSpace::RgbColorSpace(std::string name, const std::array<Chromaticity, 3>& primaries,
                             const Xyz& white)
    : RgbColorSpace(std::move(name), inverse(xyz_from_rgb_matrix(primaries, white))) {}

RgbColorSpace::RgbColorSpace(std::string name, const Matrix3& rgb_from_xyz)
    : name_(std::move(name)), rgb_from_xyz_(rgb_from_xyz), xyz_from_rgb_(inverse(rgb_from_xyz)) {}

std::array<Chromaticity, 3> RgbColorSpace::primaries() const {
  std::array<Chromaticity, 3> result;
  for (int k = 0; k < 3; ++k)
    result[k] = chromaticity({xyz_from_rgb_[0][k], xyz_from_rgb_[1][k], xyz_from_rgb_[2][k]});
  return result;
}

Xyz RgbColorSpace::white_xyz() const { return xyz_from_rgb_ * Vector3{1, 1, 1}; }

bool RgbColorSpace::is_xyz() const { return rgb_from_xyz_ == identity_matrix(); }

RgbColorSpace xyz_color_space() { return {"xyz", identity_matrix()}; }

RgbColorSpace lin_rec709_color_space() {
  // ITU-R BT.709-6, item 1.3 and 1.4.
  return {"lin_rec709",
          {{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}},
          xyz_from_chromaticity({0.3127, 0.3290})};
}

Matrix3 bradford_adaptation(const Xyz& from_white, const Xyz& to_white) {
  constexpr Matrix3 cone_from_xyz = {
      {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
  const Vector3 from = cone_from_xyz * from_white;
  const Vector3 to = cone_from_xyz * to_white;
  for (int k = 0; k < 3; ++k)
    if (!(from[k] > 0) || !(to[k] > 0))
      throw InputError("", "a colour so saturated can't be adapted to as white");
  return inverse(cone_from_xyz) *
         (diagonal_matrix({to[0] / from[0], to[1] / from[1], to[2] / from[2]}) * cone_from_xyz);
}

}  // namespace glare
