#include "glare/wavefront/wavefront_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "glare/base/error.h"
#include "glare/base/parallel.h"

namespace glare {

namespace {

constexpr double kUmPerNm = 1e-3;
constexpr double kRadPerCycle = 2 * std::numbers::pi;

/// W in focus over the pupil, with the Zernike sum made once.
class PathInFocus {
 public:
  explicit PathInFocus(const Aberrations& a)
      : defocus_dioptre_(a.defocus_dioptre),
        per_mm_(a.zernike.coefficients.empty() ? 0 : 2 / a.zernike.pupil_diameter_mm),
        sum_(a.zernike.coefficients) {}

  double operator()(double x_mm, double y_mm) const {
    return -defocus_dioptre_ * (x_mm * x_mm + y_mm * y_mm) / 2 +
           sum_(x_mm * per_mm_, y_mm * per_mm_);
  }

 private:
  double defocus_dioptre_, per_mm_;
  ZernikeSum sum_;
};

}  // namespace

WavefrontMap::WavefrontMap(const Aperture& aperture, const Aberrations& aberrations, int threads)
    : aperture_(aperture),
      aberrations_(aberrations),
      grid_(aperture, aberrations.pupil_center),
      part_(open_part(aperture)),
      path_um_(Image<float>::uninitialized(part_.width, part_.height)) {
  require_within_zernike_pupil();
  const PathInFocus path(aberrations);
  const auto one_row = [&](int y) {
    const double y_mm = grid_.y_mm(part_.y0 + y);
    for (int x = 0; x < part_.width; ++x)
      path_um_(x, y) = static_cast<float>(path(grid_.x_mm(part_.x0 + x), y_mm));
  };
  parallel_for(part_.height, threads, one_row);
  collect_samples();
}

double WavefrontMap::squared_distance_mm2(int x, int y) const {
  const double x_mm = grid_.x_mm(part_.x0 + x), y_mm = grid_.y_mm(part_.y0 + y);
  return x_mm * x_mm + y_mm * y_mm;
}

/// Pupils are a little elliptic and irregular; samples of a band-limited aperture waver beyond its
/// edge.
void WavefrontMap::require_within_zernike_pupil() const {
  constexpr double kTolerance = 1.05;
  constexpr float kOpen = 0.25;
  if (aberrations_.zernike.coefficients.empty()) return;
  double farthest_mm2 = 0;
  for (int y = 0; y < part_.height; ++y) {
    const auto row = aperture_.transmittance.row(part_.y0 + y);
    for (int x = 0; x < part_.width; ++x)
      if (row[static_cast<std::size_t>(part_.x0 + x)] > kOpen)
        farthest_mm2 = std::max(farthest_mm2, squared_distance_mm2(x, y));
  }
  const double diameter_mm = aberrations_.zernike.pupil_diameter_mm;
  const double open_mm = 2 * (std::sqrt(farthest_mm2) - aperture_.pixel_mm());
  if (open_mm <= kTolerance * diameter_mm) return;
  char text[200];
  std::snprintf(text, sizeof text,
                "the Zernike coefficients are for a pupil of %g mm and the aperture is open to "
                "%.4g mm across; give coefficients for that pupil, or a smaller one",
                diameter_mm, open_mm);
  throw OptionError(text);
}

void WavefrontMap::amplitude_row(int y, double wavelength_nm,
                                 std::span<std::complex<float>> result) const {
  const double dioptre = chromatic_difference_dioptre(aberrations_, wavelength_nm);
  const double cycles_per_um = 1 / (wavelength_nm * kUmPerNm);
  const auto open =
      aperture_.transmittance.row(part_.y0 + y)
          .subspan(static_cast<std::size_t>(part_.x0), static_cast<std::size_t>(part_.width));
  const auto path = path_um_.row(y);
  for (std::size_t x = 0; x < open.size(); ++x) {
    result[x] = {0, 0};
    if (open[x] == 0) continue;
    double path_um = path[x];
    if (dioptre != 0) path_um -= dioptre / 2 * squared_distance_mm2(static_cast<int>(x), y);
    const double cycles = path_um * cycles_per_um;
    const auto phase = static_cast<float>(kRadPerCycle * (cycles - std::floor(cycles)));
    result[x] = {open[x] * std::cos(phase), open[x] * std::sin(phase)};
  }
}

void WavefrontMap::collect_samples() {
  constexpr int kAcross = 96;
  const int step = std::max(1, std::max(part_.width, part_.height) / kAcross);
  for (int y = 0; y < part_.height; y += step)
    for (int x = 0; x < part_.width; x += step)
      if (aperture_.transmittance(part_.x0 + x, part_.y0 + y) != 0)
        samples_.push_back({path_um_(x, y), -squared_distance_mm2(x, y) / 2});
}

double WavefrontMap::phase_spread_rad(double from_nm, double to_nm) const {
  const double from_dioptre = chromatic_difference_dioptre(aberrations_, from_nm);
  const double to_dioptre = chromatic_difference_dioptre(aberrations_, to_nm);
  const double per_um = 1 / to_nm - 1 / from_nm;
  const double per_um_per_dioptre = to_dioptre / to_nm - from_dioptre / from_nm;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const Sample& sample : samples_) {
    const double cycles =
        (sample.path_um * per_um + sample.path_um_per_dioptre * per_um_per_dioptre) / kUmPerNm;
    low = std::min(low, cycles);
    high = std::max(high, cycles);
  }
  return samples_.empty() ? 0 : kRadPerCycle * (high - low);
}

double WavefrontMap::largest_step_um(double dioptre) const {
  double largest = 0;
  const auto open = [&](int x, int y) {
    return aperture_.transmittance(part_.x0 + x, part_.y0 + y) != 0;
  };
  const auto path_um = [&](int x, int y) {
    return path_um_(x, y) - dioptre / 2 * squared_distance_mm2(x, y);
  };
  for (int y = 0; y < part_.height; ++y)
    for (int x = 0; x < part_.width; ++x) {
      if (!open(x, y)) continue;
      const double here_um = path_um(x, y);
      if (x + 1 < part_.width && open(x + 1, y))
        largest = std::max(largest, std::abs(path_um(x + 1, y) - here_um));
      if (y + 1 < part_.height && open(x, y + 1))
        largest = std::max(largest, std::abs(path_um(x, y + 1) - here_um));
    }
  return largest;
}

double WavefrontMap::largest_phase_step_rad(const WavelengthRange& range) const {
  double largest = 0;
  for (const double nm : {range.lo_nm, range.hi_nm})
    largest = std::max(
        largest, largest_step_um(chromatic_difference_dioptre(aberrations_, nm)) / (nm * kUmPerNm));
  return kRadPerCycle * largest;
}

std::uint64_t WavefrontMap::bytes(int width, int height) {
  return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * sizeof(float);
}

double steepest_slope_rad(const Aberrations& aberrations, double radius_mm,
                          const WavelengthRange& range) {
  constexpr int kDistances = 64, kAngles = 64;
  constexpr double kRadPerUmPerMm = 1e-3;
  const double step_mm = 1e-3 * radius_mm;
  const PathInFocus path(aberrations);
  double steepest = 0;
  for (const double nm : {range.lo_nm, range.hi_nm}) {
    const double dioptre = chromatic_difference_dioptre(aberrations, nm);
    const auto path_um = [&](double x, double y) {
      return path(x, y) - dioptre * (x * x + y * y) / 2;
    };
    for (int i = 1; i <= kDistances; ++i)
      for (int k = 0; k < kAngles; ++k) {
        const double r = radius_mm * i / kDistances, a = kRadPerCycle * k / kAngles;
        const double x = r * std::cos(a), y = r * std::sin(a);
        const double along_x = path_um(x + step_mm, y) - path_um(x - step_mm, y);
        const double along_y = path_um(x, y + step_mm) - path_um(x, y - step_mm);
        steepest = std::max(steepest, std::hypot(along_x, along_y) / (2 * step_mm));
      }
  }
  return steepest * kRadPerUmPerMm;
}

}  // namespace glare
