#include "support/exact_template.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "glare/base/parallel.h"

namespace glare::exact {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMmPerNm = 1e-6;

// ---- Real matrices, row by row: everything below is a product of a few of them ----

struct Matrix {
  Matrix(int row_count, int column_count)
      : rows(row_count),
        columns(column_count),
        values(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(column_count)) {}
  double* row(int r) { return values.data() + static_cast<std::ptrdiff_t>(r) * columns; }
  const double* row(int r) const {
    return values.data() + static_cast<std::ptrdiff_t>(r) * columns;
  }

  int rows;
  int columns;
  std::vector<double> values;
};

// out[c] += sum over four rows of b, from row k, of a[k] b(k, c).
void add_four_rows(double* __restrict out, const double* __restrict a, const Matrix& b, int k) {
  const double a0 = a[k], a1 = a[k + 1], a2 = a[k + 2], a3 = a[k + 3];
  const double* __restrict b0 = b.row(k);
  const double* __restrict b1 = b.row(k + 1);
  const double* __restrict b2 = b.row(k + 2);
  const double* __restrict b3 = b.row(k + 3);
  for (int c = 0; c < b.columns; ++c) out[c] += a0 * b0[c] + a1 * b1[c] + a2 * b2[c] + a3 * b3[c];
}

void add_row(double* __restrict out, double a, const double* __restrict b, int columns) {
  for (int c = 0; c < columns; ++c) out[c] += a * b[c];
}

// a b. The rows of b are taken in blocks that stay in the cache.
Matrix product(const Matrix& a, const Matrix& b) {
  constexpr int kBlock = 32;
  Matrix out(a.rows, b.columns);
  for (int begin = 0; begin < b.rows; begin += kBlock) {
    const int end = std::min(begin + kBlock, b.rows);
    for (int r = 0; r < a.rows; ++r) {
      int k = begin;
      for (; k + 4 <= end; k += 4) add_four_rows(out.row(r), a.row(r), b, k);
      for (; k < end; ++k) add_row(out.row(r), a.row(r)[k], b.row(k), b.columns);
    }
  }
  return out;
}

Matrix transposed(const Matrix& m) {
  Matrix out(m.columns, m.rows);
  for (int r = 0; r < m.rows; ++r) {
    for (int c = 0; c < m.columns; ++c) out.row(c)[r] = m.row(r)[c];
  }
  return out;
}

struct CosineAndSine {
  Matrix cosine;
  Matrix sine;
};

// ---- The autocorrelation of the aperture's samples ----

// How often |n| stands for a term in a sum over all n of either sign.
double multiplicity(int n) { return n == 0 ? 1.0 : 2.0; }

// The samples inside the bounding box of those that are not 0. A shift of the aperture does not
// change the point spread function.
Matrix open_samples(const Image<float>& t) {
  int left = t.width(), right = -1, top = t.height(), bottom = -1;
  for (int y = 0; y < t.height(); ++y) {
    for (int x = 0; x < t.width(); ++x) {
      if (t(x, y) == 0) continue;
      left = std::min(left, x), right = std::max(right, x);
      top = std::min(top, y), bottom = std::max(bottom, y);
    }
  }
  if (right < 0) throw std::invalid_argument("exact template: nothing gets through the aperture");
  Matrix out(bottom - top + 1, right - left + 1);
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) out.row(y - top)[x - left] = t(x, y);
  }
  return out;
}

// cos and sin of 2 pi k x / (2 n - 1), for k and x in [0, n): the frequencies that determine a
// real sequence of 2 n - 1 terms. Both are symmetric.
CosineAndSine fourier_matrices(int n) {
  const long long period = 2LL * n - 1;
  CosineAndSine out{Matrix(n, n), Matrix(n, n)};
  for (int k = 0; k < n; ++k) {
    for (int x = 0; x < n; ++x) {
      const double angle =
          2 * kPi * static_cast<double>(1LL * k * x % period) / static_cast<double>(period);
      out.cosine.row(k)[x] = std::cos(angle);
      out.sine.row(k)[x] = std::sin(angle);
    }
  }
  return out;
}

// The autocorrelation a(s) = sum_x t(x) t(x + s) at lags s_x, s_y >= 0, which is all of it as
// a(-s) = a(s):
//   even(s_y, s_x) = (a(s_x, s_y) + a(-s_x, s_y)) / 2,
//   odd(s_y, s_x)  = (a(s_x, s_y) - a(-s_x, s_y)) / 2.
struct Autocorrelation {
  Matrix even;
  Matrix odd;
};

// The power spectrum |T|^2 of t, in the same form, times the number of terms that each of its
// frequencies stands for, over the number of all. With u = k_x x, v = k_y y:
//   T = sum t exp(-i (u + v)) = (cc - ss) - i (sc + cs),  where cs = sum t cos v sin u, ...
//   |T(k_x, k_y)|^2 +- |T(-k_x, k_y)|^2 = 2 (cc^2 + ss^2 + sc^2 + cs^2), 4 (sc cs - cc ss).
Autocorrelation power_spectrum(const Matrix& t, const CosineAndSine& by_y,
                               const CosineAndSine& by_x) {
  const Matrix cosine_rows = product(by_y.cosine, t);
  const Matrix sine_rows = product(by_y.sine, t);
  const Matrix cc = product(cosine_rows, by_x.cosine), cs = product(cosine_rows, by_x.sine);
  const Matrix sc = product(sine_rows, by_x.cosine), ss = product(sine_rows, by_x.sine);
  const double frequencies = (2.0 * t.rows - 1) * (2.0 * t.columns - 1);
  Autocorrelation out{Matrix(t.rows, t.columns), Matrix(t.rows, t.columns)};
  for (int y = 0; y < t.rows; ++y) {
    for (int x = 0; x < t.columns; ++x) {
      const double weight = multiplicity(x) * multiplicity(y) / frequencies;
      const double c_c = cc.row(y)[x], c_s = cs.row(y)[x], s_c = sc.row(y)[x], s_s = ss.row(y)[x];
      out.even.row(y)[x] = weight * (c_c * c_c + s_s * s_s + s_c * s_c + c_s * c_s);
      out.odd.row(y)[x] = weight * 2 * (s_c * c_s - c_c * s_s);
    }
  }
  return out;
}

// By the correlation theorem: a is the inverse Fourier transform of |T|^2. With 2 n - 1
// frequencies along an axis of n samples no lag wraps around onto another, so this is exact; the
// transforms are plain matrix products.
Autocorrelation autocorrelation(const Matrix& t) {
  const CosineAndSine by_y = fourier_matrices(t.rows);
  const CosineAndSine by_x = fourier_matrices(t.columns);
  const Autocorrelation power = power_spectrum(t, by_y, by_x);
  Autocorrelation a{product(product(by_y.cosine, power.even), by_x.cosine),
                    product(product(by_y.sine, power.odd), by_x.sine)};
  for (double& value : a.odd.values) value = -value;
  return a;
}

// ---- The pattern at one wavelength ----

double sinc(double x) { return x == 0 ? 1.0 : std::sin(x) / x; }

// Along one axis, for the lags s = 0, 1, ... (rows) and the pixels at `index` times the pitch
// (columns): m(s) sinc(pi r s) cos(2 pi r s index), and the same with sin. r is p pitch / lambda;
// sinc is the mean over the pixel. The angles are stepped from lag to lag, which rounds by less
// than 1e-13 after 1000 steps.
CosineAndSine pixel_waves(int lags, const std::vector<int>& index, double r) {
  const int columns = static_cast<int>(index.size());
  CosineAndSine out{Matrix(lags, columns), Matrix(lags, columns)};
  std::vector<double> step_cos(index.size()), step_sin(index.size());
  std::vector<double> c(index.size(), 1.0), s(index.size(), 0.0);
  for (std::size_t i = 0; i < index.size(); ++i) {
    step_cos[i] = std::cos(2 * kPi * r * index[i]);
    step_sin[i] = std::sin(2 * kPi * r * index[i]);
  }
  for (int lag = 0; lag < lags; ++lag) {
    const double weight = multiplicity(lag) * sinc(kPi * r * lag);
    for (int i = 0; i < columns; ++i) {
      out.cosine.row(lag)[i] = weight * c[i];
      out.sine.row(lag)[i] = weight * s[i];
      const double next = c[i] * step_cos[i] - s[i] * step_sin[i];
      s[i] = s[i] * step_cos[i] + c[i] * step_sin[i];
      c[i] = next;
    }
  }
  return out;
}

// The aperture and the pixels, made ready for any wavelength.
class Pattern {
 public:
  Pattern(const Aperture& aperture, const Request& request)
      : a_(autocorrelation(open_samples(aperture.transmittance))),
        sample_mm_(aperture.pixel_mm()),
        pitch_rad_(request.pitch_rad()) {
    for (int i = 0; i < request.width; ++i) column_index_.push_back(i - request.width / 2);
    for (const int j : request.rows) {
      if (j < 0 || j >= request.height) throw std::invalid_argument("exact template: no such row");
      row_index_.push_back(j - request.height / 2);
    }
  }

  // |T|^2 is the Fourier transform of the autocorrelation, p^4 sum_s a(s) cos(2 pi p s.theta /
  // lambda), its mean over a pixel has sinc(pi r s_x) sinc(pi r s_y) in each term, and
  // cos(u + v) = cos u cos v - sin u sin v makes that a product of matrices:
  //   PSF = p^2 / (lambda^2 a(0)) (cos_y even cos_x - sin_y odd sin_x).
  Matrix at(double wavelength_nm) const {
    const double lambda_mm = wavelength_nm * kMmPerNm;
    const double r = sample_mm_ * pitch_rad_ / lambda_mm;
    const CosineAndSine x = pixel_waves(a_.even.columns, column_index_, r);
    const CosineAndSine y = pixel_waves(a_.even.rows, row_index_, r);
    Matrix out = product(product(transposed(y.cosine), a_.even), x.cosine);
    const Matrix sines = product(product(transposed(y.sine), a_.odd), x.sine);
    const double scale = sample_mm_ * sample_mm_ / (lambda_mm * lambda_mm * a_.even.row(0)[0]);
    for (std::size_t i = 0; i < out.values.size(); ++i) {
      out.values[i] = scale * (out.values[i] - sines.values[i]);
    }
    return out;
  }

 private:
  Autocorrelation a_;
  double sample_mm_;
  double pitch_rad_;
  std::vector<int> column_index_;
  std::vector<int> row_index_;
};

// ---- The integral over wavelength ----

struct Node {
  double wavelength_nm;
  double weight_nm;
};

void add_knots(std::vector<double>& ends, const SpectralTable& table, double lo, double hi) {
  for (const double knot : table.wavelength_nm) {
    if (knot > lo && knot < hi) ends.push_back(knot);
  }
}

// The limits, whole nanometres and knots between them: between two, every table is linear.
std::vector<double> interval_ends(const Observer& observer, const std::vector<SpectralTable>& lamps,
                                  double lo, double hi) {
  if (!(lo < hi)) throw std::invalid_argument("exact template: an empty range of wavelengths");
  std::vector<double> ends{lo, hi};
  for (double nm = std::floor(lo) + 1; nm < hi; ++nm) ends.push_back(nm);
  for (const SpectralTable& table : observer) add_knots(ends, table, lo, hi);
  for (const SpectralTable& table : lamps) add_knots(ends, table, lo, hi);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

// Two-point Gauss-Legendre on each interval's parts: middle -+ width / (2 sqrt 3).
std::vector<Node> quadrature(const std::vector<double>& ends, int refine) {
  if (refine < 1) throw std::invalid_argument("exact template: refine is at least 1");
  const double offset = 0.5 / std::numbers::sqrt3;
  std::vector<Node> nodes;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double part = (ends[i + 1] - ends[i]) / refine;
    for (int j = 0; j < refine; ++j) {
      const double middle = ends[i] + (j + 0.5) * part;
      nodes.push_back({middle - offset * part, part / 2});
      nodes.push_back({middle + offset * part, part / 2});
    }
  }
  return nodes;
}

// What the pattern at this node adds to the lamp's X, Y and Z.
Xyz node_xyz(const Node& node, const Observer& observer, const SpectralTable& lamp) {
  const double light = node.weight_nm * value_at(lamp, node.wavelength_nm);
  Xyz out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = light * value_at(observer[c], node.wavelength_nm);
  return out;
}

// integral S (x, y, z) dlambda. The rule is exact for it: the integrand is piecewise quadratic.
Xyz integral_xyz(const std::vector<Node>& nodes, const Observer& observer,
                 const SpectralTable& lamp) {
  Xyz sum{};
  for (const Node& node : nodes) {
    const Xyz term = node_xyz(node, observer, lamp);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += term[c];
  }
  if (!(sum[1] > 0)) throw std::invalid_argument("exact template: a lamp without luminance");
  return sum;
}

void add_pattern(Image<Xyz>& image, const Matrix& pattern, const Xyz& weight) {
  for (std::size_t i = 0; i < pattern.values.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) image.values()[i][c] += pattern.values[i] * weight[c];
  }
}

// The nodes at which some lamp has something to be seen.
std::vector<Node> visible(const std::vector<Node>& nodes, const Observer& observer,
                          const std::vector<SpectralTable>& lamps) {
  std::vector<Node> out;
  for (const Node& node : nodes) {
    const bool seen = std::any_of(lamps.begin(), lamps.end(), [&](const SpectralTable& lamp) {
      return node_xyz(node, observer, lamp) != Xyz{};
    });
    if (seen) out.push_back(node);
  }
  return out;
}

}  // namespace

double value_at(const SpectralTable& table, double wavelength_nm) {
  const std::vector<double>& knots = table.wavelength_nm;
  if (knots.empty() || wavelength_nm < knots.front() || wavelength_nm > knots.back()) return 0;
  if (wavelength_nm == knots.back()) return table.value.back();
  const auto above = std::upper_bound(knots.begin(), knots.end(), wavelength_nm) - knots.begin();
  const double share = (wavelength_nm - knots[above - 1]) / (knots[above] - knots[above - 1]);
  return (1 - share) * table.value[above - 1] + share * table.value[above];
}

double Request::pitch_rad() const { return fov_deg * kPi / 180 / width; }

double psf_point(const Aperture& aperture, double theta_x, double theta_y, double wavelength_nm) {
  const double p = aperture.pixel_mm();
  const double lambda_mm = wavelength_nm * kMmPerNm;
  std::complex<double> sum = 0;
  double energy = 0;
  for (int y = 0; y < aperture.transmittance.height(); ++y) {
    for (int x = 0; x < aperture.transmittance.width(); ++x) {
      const double t = aperture.transmittance(x, y);
      sum += std::polar(t, -2 * kPi * p * (x * theta_x + y * theta_y) / lambda_mm);
      energy += t * t;
    }
  }
  const double area_mm2 = p * p * energy;
  return std::norm(p * p * sum) / (lambda_mm * lambda_mm * area_mm2);
}

Image<double> psf(const Aperture& aperture, const Request& request, double wavelength_nm) {
  const Matrix pattern = Pattern(aperture, request).at(wavelength_nm);
  Image<double> out(pattern.columns, pattern.rows);
  std::copy(pattern.values.begin(), pattern.values.end(), out.values().begin());
  return out;
}

std::vector<Image<Xyz>> xyz(const Aperture& aperture, const Request& request,
                            const Observer& observer, const std::vector<SpectralTable>& lamps) {
  constexpr int kBatch = 32;  // Patterns in memory at once; added in the order of wavelengths.
  const std::vector<Node> all = quadrature(
      interval_ends(observer, lamps, request.lambda_lo_nm, request.lambda_hi_nm), request.refine);
  const std::vector<Node> nodes = visible(all, observer, lamps);
  std::vector<double> luminance;
  for (const SpectralTable& lamp : lamps) {
    luminance.push_back(integral_xyz(all, observer, lamp)[1]);
  }
  const int row_count = static_cast<int>(request.rows.size());
  std::vector<Image<Xyz>> out(lamps.size(), Image<Xyz>(request.width, row_count));
  const Pattern pattern(aperture, request);
  const int count = static_cast<int>(nodes.size());
  for (int begin = 0; begin < count; begin += kBatch) {
    const int size = std::min(kBatch, count - begin);
    std::vector<Matrix> batch(size, Matrix(0, 0));
    parallel_for(size, request.threads,
                 [&](int i) { batch[i] = pattern.at(nodes[begin + i].wavelength_nm); });
    for (int i = 0; i < size; ++i) {
      for (std::size_t l = 0; l < lamps.size(); ++l) {
        Xyz weight = node_xyz(nodes[begin + i], observer, lamps[l]);
        for (double& w : weight) w /= luminance[l];
        add_pattern(out[l], batch[i], weight);
      }
    }
  }
  return out;
}

Xyz lamp_xyz(const Observer& observer, const SpectralTable& lamp, double lambda_lo_nm,
             double lambda_hi_nm) {
  const std::vector<double> ends = interval_ends(observer, {lamp}, lambda_lo_nm, lambda_hi_nm);
  Xyz out = integral_xyz(quadrature(ends, 1), observer, lamp);
  const double luminance = out[1];
  for (double& component : out) component /= luminance;
  return out;
}

}  // namespace glare::exact
