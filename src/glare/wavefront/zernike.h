// Zernike polynomials as the optics of the eye counts them: OSA/ANSI standard indices.
#pragma once

#include <span>
#include <vector>

namespace glare {

/// Radial order n >= 0 and azimuthal frequency m, |m| <= n, n - |m| even.
struct ZernikeIndex {
  int n = 0;
  int m = 0;

  friend bool operator==(const ZernikeIndex&, const ZernikeIndex&) = default;
};

/// The highest radial order that is taken: to there double precision holds 1e-7 of a polynomial.
inline constexpr int kHighestZernikeOrder = 20;

/// True where n and m are as above, and n is at most `kHighestZernikeOrder`.
bool is_valid(const ZernikeIndex& index);

/// The single index j = (n (n + 2) + m) / 2 of a valid pair, and back (j >= 0).
int zernike_j(const ZernikeIndex& index);
ZernikeIndex zernike_index(int j);

/// The highest j: that of n = m = `kHighestZernikeOrder`.
int highest_zernike_j();

/// A term of a sum of polynomials.
struct ZernikeCoefficient {
  int j = 0;
  double value_um = 0;

  friend bool operator==(const ZernikeCoefficient&, const ZernikeCoefficient&) = default;
};

/// The sum of coefficient * Z_j(x, y) over the unit disc, where
///   Z_n^m = N R_n^|m|(r) cos(m a) for m >= 0, N R_n^|m|(r) sin(|m| a) for m < 0,
///   N = sqrt(2 (n + 1) / (1 + [m = 0])),
/// r is the distance from the centre and a the angle, anticlockwise from the x axis. The mean of
/// Z_j Z_k over the disc is 1 for j = k, else 0: the root mean square of the sum is that of its
/// coefficients (but for j = 0). Every j is from 0 to `highest_zernike_j()`; one that is there
/// twice counts twice.
///
/// Thibos, Applegate, Schwiegerling, Webb: Standards for reporting the optical aberrations of eyes.
/// Journal of Refractive Surgery 18 (2002); ANSI Z80.28; ISO 24157.
class ZernikeSum {
 public:
  explicit ZernikeSum(std::span<const ZernikeCoefficient> coefficients);

  /// Its value, in the coefficients' unit, also beyond the disc.
  double operator()(double x, double y) const;

 private:
  /// r^m (cosine(r^2) cos(m a) + sine(r^2) sin(m a)), by powers of r^2.
  struct Frequency {
    std::vector<double> cosine, sine;
  };
  std::vector<Frequency> frequencies_;  ///< By m >= 0.
};

}  // namespace glare
