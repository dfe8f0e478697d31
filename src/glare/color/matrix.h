// Three numbers and 3 x 3 matrices, in double precision.
#pragma once

#include <array>

namespace glare {

using Vector3 = std::array<double, 3>;

/// CIE tristimulus values X, Y, Z.
using Xyz = Vector3;

/// Row by row: `m[row][column]`; applied to a column vector on its right.
using Matrix3 = std::array<Vector3, 3>;

Matrix3 identity_matrix();
Matrix3 diagonal_matrix(const Vector3& diagonal);
Vector3 operator*(const Matrix3& m, const Vector3& v);
Matrix3 operator*(const Matrix3& a, const Matrix3& b);

/// The inverse of `m`. Throws `InputError` when `m` is singular or holds a value that isn't finite.
Matrix3 inverse(const Matrix3& m);

}  // namespace glare
