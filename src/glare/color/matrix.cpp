#include "glare/color/matrix.h"

#include <cmath>

#include "glare/base/error.h"

namespace glare {

Matrix3 identity_matrix() { return diagonal_matrix({1, 1, 1}); }

Matrix3 diagonal_matrix(const Vector3& d) { return {{{d[0], 0, 0}, {0, d[1], 0}, {0, 0, d[2]}}}; }

Vector3 operator*(const Matrix3& m, const Vector3& v) {
  Vector3 product;
  for (int row = 0; row < 3; ++row)
    product[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
  return product;
}

Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
  Matrix3 product{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      for (int k = 0; k < 3; ++k) product[row][column] += a[row][k] * b[k][column];
  return product;
}

Matrix3 inverse(const Matrix3& m) {
  const auto cofactor = [&](int row, int column) {
    const int r0 = (row + 1) % 3, r1 = (row + 2) % 3;
    const int c0 = (column + 1) % 3, c1 = (column + 2) % 3;
    return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
  };
  const double determinant =
      m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  if (!std::isfinite(determinant) || std::abs(determinant) < 1e-12)
    throw InputError("", "a colour matrix can't be inverted: its primaries lie on one line");
  Matrix3 result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      result[row][column] = cofactor(column, row) / determinant;
  return result;
}

}  // namespace glare
