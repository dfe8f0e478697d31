#include "glare/integration/log_spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "glare/base/units.h"
#include "glare/diffraction/fourier_transform.h"

namespace glare {

namespace {

/// A node of a rule on [0, 1] and its weight (Abramowitz and Stegun 25.4).
struct GaussPoint {
  double place, weight;
};
constexpr std::array<GaussPoint, 2> kTwoPoints = {
    {{0.211324865405187118, 0.5}, {0.788675134594812882, 0.5}}};
constexpr std::array<GaussPoint, 4> kFourPoints = {{{0.069431844202973712, 0.173927422568726929},
                                                    {0.330009478207571868, 0.326072577431273071},
                                                    {0.669990521792428132, 0.326072577431273071},
                                                    {0.930568155797026288, 0.173927422568726929}}};

/// Steps of the logarithm beyond the spectrum's ends, over which the kernel spreads it.
int margin() { return log_interpolation().taps() / 2; }

/// As many steps as a range of logarithms takes, with the margins.
LogSpectrum empty_spectrum(double first_log, double last_log, double log_step) {
  const auto steps = static_cast<std::size_t>(std::ceil((last_log - first_log) / log_step));
  LogSpectrum result;
  result.first_log_per_mm = first_log - margin() * log_step;
  result.log_step = log_step;
  result.weights.assign(steps + 1 + 2 * static_cast<std::size_t>(margin()), Xyz{0, 0, 0});
  return result;
}

/// Adds light at one place.
void add(const Xyz& light, double log_per_mm, LogSpectrum& spectrum) {
  const double place = (log_per_mm - spectrum.first_log_per_mm) / spectrum.log_step;
  const double whole = std::floor(place);
  const auto weights = log_interpolation().weights_at(place - whole);
  Xyz* const target = spectrum.weights.data() + static_cast<std::ptrdiff_t>(whole) - margin() + 1;
  for (int j = 0; j < 2 * margin(); ++j)
    for (int k = 0; k < 3; ++k) target[j][k] += weights[j] * light[k];
}

/// What is integrated, at one wavelength.
struct Light {
  double power;
  Xyz observer;
};

/// Integrates S (x̄, ȳ, z̄) / lambda^2 over an interval in which both factors are linear.
void integrate(double lo_nm, double hi_nm, const Light& lo, const Light& hi,
               LogSpectrum& spectrum) {
  const double steps = std::log(hi_nm / lo_nm) / spectrum.log_step;
  const auto one_part = [&](double from, double to, auto rule) {
    for (const GaussPoint& point : rule) {
      const double t = from + (to - from) * point.place;
      const double lambda_mm = (lo_nm + t * (hi_nm - lo_nm)) * kMmPerNm;
      const double scale = point.weight * (to - from) * (hi_nm - lo_nm) *
                           (lo.power + t * (hi.power - lo.power)) / (lambda_mm * lambda_mm);
      Xyz light;
      for (int k = 0; k < 3; ++k)
        light[k] = scale * (lo.observer[k] + t * (hi.observer[k] - lo.observer[k]));
      add(light, -std::log(lambda_mm), spectrum);
    }
  };
  constexpr double kShort = 0.35, kLong = 0.7;  // Steps that the rules integrate the kernel over.
  if (steps < kShort) return one_part(0.0, 1.0, kTwoPoints);
  const int parts = static_cast<int>(std::ceil(steps / kLong));
  for (int i = 0; i < parts; ++i)
    one_part(static_cast<double>(i) / parts, (i + 1.0) / parts, kFourPoints);
}

}  // namespace

LogSpectrum log_spectrum(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                         const WavelengthRange& range, double log_step) {
  LogSpectrum result = empty_spectrum(-std::log(range.hi_nm * kMmPerNm),
                                      -std::log(range.lo_nm * kMmPerNm), log_step);
  const auto light_at = [&](double nm) {
    return Light{lamp(nm), {observer.x_bar(nm), observer.y_bar(nm), observer.z_bar(nm)}};
  };
  const std::array<const Spectrum*, 2> spectra = {&lamp, &observer.y_bar};
  const std::vector<double> knots_nm = union_of_knots(spectra, range);
  Light lo = light_at(knots_nm.front());
  for (std::size_t i = 1; i < knots_nm.size(); ++i) {
    const Light hi = light_at(knots_nm[i]);
    if (lo.power != 0 || hi.power != 0) integrate(knots_nm[i - 1], knots_nm[i], lo, hi, result);
    lo = hi;
  }
  const double luminance = luminous_integral(lamp, observer, range);
  for (Xyz& weight : result.weights)
    for (double& w : weight) w /= luminance;
  return result;
}

LogSpectrum resampled(const LogSpectrum& spectrum, double log_step) {
  const double last = spectrum.first_log_per_mm +
                      static_cast<double>(spectrum.weights.size() - 1) * spectrum.log_step;
  LogSpectrum result = empty_spectrum(spectrum.first_log_per_mm, last, log_step);
  for (std::size_t i = 0; i < spectrum.weights.size(); ++i)
    add(spectrum.weights[i], spectrum.first_log_per_mm + static_cast<double>(i) * spectrum.log_step,
        result);
  return result;
}

DetailSpectrum::DetailSpectrum(const LogSpectrum& spectrum) {
  constexpr int kZeroPadding = 2;
  const int length =
      fast_transform_length(kZeroPadding * static_cast<int>(spectrum.weights.size()));
  const FourierTransform transform(FourierTransform::Kind::real_to_complex, length);
  AlignedBuffer<float> weights(static_cast<std::size_t>(length));
  AlignedBuffer<std::complex<float>> frequencies(static_cast<std::size_t>(length / 2 + 1));
  step_ = 1 / (length * spectrum.log_step);
  above_.assign(frequencies.values().size(), 0.0);
  for (int c = 0; c < 3; ++c) {
    const auto rest =
        std::transform(spectrum.weights.begin(), spectrum.weights.end(), weights.values().begin(),
                       [c](const Xyz& w) { return static_cast<float>(w[c]); });
    std::fill(rest, weights.values().end(), 0.0f);
    transform.execute(weights, frequencies);
    const double all = std::norm(frequencies.values()[0]);
    double sum = 0;
    for (std::size_t k = above_.size(); k-- > 0 && all > 0;) {
      sum += std::norm(frequencies.values()[k]) / all * step_;
      above_[k] = std::max(above_[k], sum);
    }
  }
}

double DetailSpectrum::cutoff(double pattern_bandwidth, double share) const {
  const double allowed = share * share * pattern_bandwidth;
  std::size_t k = above_.size();
  while (k > 0 && above_[k - 1] <= allowed) --k;
  return static_cast<double>(k) * step_;
}

const PointInterpolation& log_interpolation() {
  static const PointInterpolation interpolation(WindowedSinc{12, 8.5});
  return interpolation;
}

}  // namespace glare
