#include "glare/wavefront/zernike.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace glare {

namespace {

double factorial(int n) { return std::round(std::tgamma(n + 1.0)); }

/// The coefficient of r^(n - 2 s) in R_n^m, m >= 0 (Born and Wolf, section 9.2).
double radial_coefficient(int n, int m, int s) {
  const double sign = s % 2 == 0 ? 1 : -1;
  return sign * factorial(n - s) /
         (factorial(s) * factorial((n + m) / 2 - s) * factorial((n - m) / 2 - s));
}

double normalization(const ZernikeIndex& index) {
  return std::sqrt(index.m == 0 ? index.n + 1.0 : 2 * (index.n + 1.0));
}

double polynomial(const std::vector<double>& coefficients, double x) {
  double sum = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * x + coefficients[k];
  return sum;
}

}  // namespace

bool is_valid(const ZernikeIndex& index) {
  return index.n >= 0 && index.n <= kHighestZernikeOrder && index.m >= -index.n &&
         index.m <= index.n && (index.n - index.m) % 2 == 0;
}

int zernike_j(const ZernikeIndex& index) {
  assert(is_valid(index));
  return (index.n * (index.n + 2) + index.m) / 2;
}

ZernikeIndex zernike_index(int j) {
  assert(j >= 0);
  int n = 0;
  while ((n + 1) * (n + 2) / 2 <= j) ++n;
  return {n, 2 * j - n * (n + 2)};
}

int highest_zernike_j() { return zernike_j({kHighestZernikeOrder, kHighestZernikeOrder}); }

ZernikeSum::ZernikeSum(std::span<const ZernikeCoefficient> coefficients) {
  for (const ZernikeCoefficient& term : coefficients) {
    const ZernikeIndex index = zernike_index(term.j);
    assert(is_valid(index));
    const int m = std::abs(index.m);
    if (static_cast<int>(frequencies_.size()) <= m)
      frequencies_.resize(static_cast<std::size_t>(m) + 1);
    Frequency& frequency = frequencies_[static_cast<std::size_t>(m)];
    auto& powers = index.m < 0 ? frequency.sine : frequency.cosine;
    const int highest = (index.n - m) / 2;
    powers.resize(std::max(powers.size(), static_cast<std::size_t>(highest) + 1), 0.0);
    for (int s = 0; s <= highest; ++s)
      powers[static_cast<std::size_t>(highest - s)] +=
          term.value_um * normalization(index) * radial_coefficient(index.n, m, s);
  }
}

double ZernikeSum::operator()(double x, double y) const {
  const double square = x * x + y * y;
  double sum = 0, cosine = 1, sine = 0;  // r^m cos(m a) and r^m sin(m a).
  for (const Frequency& frequency : frequencies_) {
    sum +=
        cosine * polynomial(frequency.cosine, square) + sine * polynomial(frequency.sine, square);
    const double next = cosine * x - sine * y;
    sine = cosine * y + sine * x;
    cosine = next;
  }
  return sum;
}

}  // namespace glare
