#include "support/gridded_intensity.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "glare/base/image.h"
#include "glare/base/parallel.h"

namespace glare::exact {
namespace {

constexpr double kPi = std::numbers::pi;

using Complex = std::complex<double>;

// ---- A plain fast Fourier transform ----

int power_of_two_from(int minimum) {
  int n = 1;
  while (n < minimum) n *= 2;
  return n;
}

// X[k] = sum x[n] exp(-2 pi i k n / length) in place, for a length that is a power of two: Cooley
// and Tukey's, with every root computed for itself.
class Fft {
 public:
  explicit Fft(int length) : length_(length) {
    for (int k = 0; k < length / 2; ++k) roots_.push_back(std::polar(1.0, -2 * kPi * k / length));
  }

  void operator()(Complex* x) const {
    for (int i = 1, j = 0; i < length_; ++i) {
      int bit = length_ / 2;
      for (; j & bit; bit /= 2) j ^= bit;
      j ^= bit;
      if (i < j) std::swap(x[i], x[j]);
    }
    for (int half = 1; half < length_; half *= 2)
      for (int begin = 0; begin < length_; begin += 2 * half)
        for (int k = 0; k < half; ++k) {
          const Complex root = roots_[k * (length_ / (2 * half))], a = x[begin + k];
          const Complex b = x[begin + half + k];
          const Complex turned(root.real() * b.real() - root.imag() * b.imag(),
                               root.real() * b.imag() + root.imag() * b.real());
          x[begin + k] = a + turned;
          x[begin + half + k] = a - turned;
        }
  }

 private:
  int length_;
  std::vector<Complex> roots_;
};

// The transforms of all rows of `rows`, and what comes out as columns: out(y, k) of rows(k, y).
Image<Complex> transposed_transforms(Image<Complex> rows, int threads) {
  constexpr int kRowsPerTask = 8;
  const Fft fft(rows.width());
  Image<Complex> out(rows.height(), rows.width());
  parallel_for((rows.height() + kRowsPerTask - 1) / kRowsPerTask, threads, [&](int task) {
    const int begin = task * kRowsPerTask, end = std::min(rows.height(), begin + kRowsPerTask);
    for (int y = begin; y < end; ++y) fft(rows.row(y).data());
    for (int k = 0; k < rows.width(); ++k)
      for (int y = begin; y < end; ++y) out(y, k) = rows(k, y);
  });
  return out;
}

// ---- The autocorrelation of the samples ----

// a(s) = sum over x of t(x) t(x + s), at (s modulo the picture's size), by the correlation
// theorem. The picture is large enough that no lag falls on another.
Image<Complex> autocorrelation(const Image<float>& t, int threads) {
  const int width = power_of_two_from(2 * t.width()), height = power_of_two_from(2 * t.height());
  Image<Complex> padded(width, height);
  for (int y = 0; y < t.height(); ++y)
    for (int x = 0; x < t.width(); ++x) padded(x, y) = t(x, y);
  Image<Complex> power =
      transposed_transforms(transposed_transforms(std::move(padded), threads), threads);
  for (Complex& value : power.values()) value = std::norm(value);
  // |T|^2 is even, and so its forward transform is the inverse one but for a factor.
  Image<Complex> a =
      transposed_transforms(transposed_transforms(std::move(power), threads), threads);
  for (Complex& value : a.values()) value /= static_cast<double>(width) * height;
  return a;
}

// 1 / transform(s / length) of the kernel for the lags 0 to count - 1.
std::vector<double> corrections(int count, int length) {
  std::vector<double> out;
  for (int s = 0; s < count; ++s)
    out.push_back(1 / GriddingKernel::transform(static_cast<double>(s) / length));
  return out;
}

}  // namespace

// ---- The kernel ----

namespace {

constexpr double kHalf = GriddingKernel::kTaps / 2.0;
// The best for samples at twice the rate that the function needs (Beatty, Nishimura and Pauly, IEEE
// Trans. Med. Imaging 24, 2005): aliases of about exp(-pi kTaps / sqrt 2) = 3e-14 are left.
constexpr double kBeta = kPi * GriddingKernel::kTaps * 0.75;

double phi(double u) {
  const double v = u / kHalf;
  if (std::abs(v) >= 1) return 0;
  return std::cyl_bessel_i(0.0, kBeta * std::sqrt(1 - v * v)) / std::cyl_bessel_i(0.0, kBeta);
}

}  // namespace

double GriddingKernel::transform(double xi) {
  const double root = std::sqrt(kBeta * kBeta - std::pow(2 * kPi * kHalf * xi, 2));
  return 2 * kHalf * std::sinh(root) / root / std::cyl_bessel_i(0.0, kBeta);
}

GriddingKernel::GriddingKernel() {
  // Three-point Gauss-Legendre on each step.
  const double offset = std::sqrt(0.6) / 2;
  std::vector<double> integral{0}, slope{phi(-kHalf)};
  for (int n = 0; n < kTaps * kSteps; ++n) {
    const auto at = [&](double share) { return phi((n + share) / kSteps - kHalf); };
    integral.push_back(integral.back() +
                       (5 * at(0.5 - offset) + 8 * at(0.5) + 5 * at(0.5 + offset)) / 18 / kSteps);
    slope.push_back(at(1));
  }
  whole_ = integral.back();
  for (int i = 0; i <= kSteps; ++i)
    for (int j = 0; j < kTaps; ++j) {
      integral_.push_back(integral[static_cast<std::size_t>(j * kSteps + i)]);
      slope_.push_back(slope[static_cast<std::size_t>(j * kSteps + i)]);
    }
}

// Adds `factor` times the integral of phi(u - k) over all u left of the edge.
void GriddingKernel::add_running(double edge, int first, double factor,
                                 std::vector<double>& weights) const {
  const double whole_part = std::floor(edge);
  const double steps = (edge - whole_part) * kSteps;
  const int i = std::min(static_cast<int>(steps), kSteps - 1);
  const double t = steps - i;
  const double value_1 = t * t * (3 - 2 * t), value_0 = 1 - value_1;
  const double slope_0 = t * (1 - t) * (1 - t) / kSteps, slope_1 = t * t * (t - 1) / kSteps;
  const double* const integral = integral_.data() + static_cast<std::ptrdiff_t>(i) * kTaps;
  const double* const slope = slope_.data() + static_cast<std::ptrdiff_t>(i) * kTaps;
  int j = static_cast<int>(whole_part) - first + kTaps / 2;  // Of the first k; one less for each.
  for (double& weight : weights) {
    if (j >= kTaps)
      weight += factor * whole_;
    else if (j >= 0)
      weight += factor * (value_0 * integral[j] + value_1 * integral[j + kTaps] +
                          slope_0 * slope[j] + slope_1 * slope[j + kTaps]);
    --j;
  }
}

int GriddingKernel::means(double left, double right, std::vector<double>& weights) const {
  const int first = static_cast<int>(std::floor(left)) - kTaps / 2 + 1;
  const int last = static_cast<int>(std::floor(right)) + kTaps / 2;
  weights.assign(static_cast<std::size_t>(last - first + 1), 0.0);
  add_running(right, first, 1 / (right - left), weights);
  add_running(left, first, -1 / (right - left), weights);
  return first;
}

// ---- The intensity ----

GriddedIntensity::GriddedIntensity(const Aperture& aperture, double widest_pixel_per_mm,
                                   int threads) {
  const Image<float>& t = aperture.transmittance;
  const double pixel_mm = aperture.pixel_mm();
  const Image<Complex> a = autocorrelation(t, threads);
  const double energy = a(0, 0).real();
  if (!(energy > 0)) throw std::invalid_argument("exact pixels: nothing gets through the aperture");

  // Twice as many frequencies as the lags, from -(N - 1) to N - 1, need.
  columns_ = power_of_two_from(4 * t.width());
  rows_ = power_of_two_from(4 * t.height());
  samples_per_mm_x_ = columns_ * pixel_mm;
  samples_per_mm_y_ = rows_ * pixel_mm;
  stride_ = columns_ + static_cast<int>(widest_pixel_per_mm * samples_per_mm_x_) +
            GriddingKernel::kTaps + 2;

  // Rows of lags, all of y but those that are 0; the transforms of the others are 0 too.
  const std::vector<double> by_x = corrections(t.width(), columns_);
  const std::vector<double> by_y = corrections(t.height(), rows_);
  const double scale = pixel_mm * pixel_mm / energy;
  const int lag_rows = 2 * t.height() - 1;
  Image<Complex> lags(columns_, lag_rows);
  for (int r = 0; r < lag_rows; ++r) {
    const int sy = r - (t.height() - 1);
    const int source_y = (sy + a.height()) % a.height();
    for (int sx = 1 - t.width(); sx < t.width(); ++sx)
      lags((sx + columns_) % columns_, r) = scale * by_x[std::abs(sx)] * by_y[std::abs(sy)] *
                                            a((sx + a.width()) % a.width(), source_y).real();
  }
  const Image<Complex> half_done = transposed_transforms(std::move(lags), threads);

  // Then along y; the intensity is real, and I(-kx, -ky) = I(kx, ky).
  const Fft fft(rows_);
  coefficients_.resize(static_cast<std::size_t>(stride_) * rows_);
  constexpr int kColumnsPerTask = 8;
  const int half = columns_ / 2;
  parallel_for(half / kColumnsPerTask + 1, threads, [&](int task) {
    std::vector<Complex> column(static_cast<std::size_t>(rows_));
    const int end = std::min(half + 1, (task + 1) * kColumnsPerTask);
    for (int kx = task * kColumnsPerTask; kx < end; ++kx) {
      std::fill(column.begin(), column.end(), Complex{});
      for (int r = 0; r < lag_rows; ++r)
        column[static_cast<std::size_t>((r - (t.height() - 1) + rows_) % rows_)] = half_done(r, kx);
      fft(column.data());
      for (int ky = 0; ky < rows_; ++ky) {
        const double value = column[static_cast<std::size_t>(ky)].real();
        coefficients_[static_cast<std::size_t>(ky) * stride_ + kx] = value;
        coefficients_[static_cast<std::size_t>((rows_ - ky) % rows_) * stride_ +
                      (columns_ - kx) % columns_] = value;
      }
    }
  });
  for (int ky = 0; ky < rows_; ++ky) {
    double* const row = coefficients_.data() + static_cast<std::ptrdiff_t>(ky) * stride_;
    for (int kx = columns_; kx < stride_; ++kx) row[kx] = row[kx % columns_];
  }
}

double GriddedIntensity::mean(const Rectangle& at, Weights& weights) const {
  const int first_x =
      kernel_.means(at.x0 * samples_per_mm_x_, at.x1 * samples_per_mm_x_, weights.x);
  const int first_y =
      kernel_.means(at.y0 * samples_per_mm_y_, at.y1 * samples_per_mm_y_, weights.y);
  const auto wrapped = [](int k, int period) { return (k % period + period) % period; };
  const int column = wrapped(first_x, columns_);
  const auto count = static_cast<int>(weights.x.size());
  double sum = 0;
  int row = wrapped(first_y, rows_);
  for (const double weight_y : weights.y) {
    const double* const values =
        coefficients_.data() + static_cast<std::ptrdiff_t>(row) * stride_ + column;
    double row_sum = 0;
    for (int i = 0; i < count; ++i) row_sum += weights.x[static_cast<std::size_t>(i)] * values[i];
    sum += weight_y * row_sum;
    if (++row == rows_) row = 0;
  }
  return sum;
}

}  // namespace glare::exact
