// The light of a lamp, as an observer sees it, over the logarithm of the wavenumber. Internal.
#pragma once

#include <vector>

#include "glare/color/matrix.h"
#include "glare/integration/point_interpolation.h"
#include "glare/spectrum/observer.h"
#include "glare/spectrum/spectrum.h"

namespace glare {

/// For any function I that is band-limited over the logarithm of the frequency, sampled densely
/// enough by the step,
///   integral of I(theta / lambda) / lambda^2 S (x̄, ȳ, z̄) dlambda / integral of S ȳ dlambda
/// is the sum over i of weights[i] I(theta nu_i), nu_i = exp(first_log_per_mm + i log_step).
struct LogSpectrum {
  double first_log_per_mm = 0;  ///< ln of a wavenumber 1 / lambda in 1 / mm.
  double log_step = 0;
  std::vector<Xyz> weights;
};

/// I is taken as its windowed-sinc interpolant between the steps, which is integrated against the
/// spectra between all their samples by Gauss-Legendre; so no line of a lamp is missed.
LogSpectrum log_spectrum(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                         const WavelengthRange& range, double log_step);

/// The same light at another, coarser step.
LogSpectrum resampled(const LogSpectrum& spectrum, double log_step);

/// How much detail a spectrum lets through to the integral.
class DetailSpectrum {
 public:
  explicit DetailSpectrum(const LogSpectrum& spectrum);

  /// The frequency, in cycles per unit of the logarithm, beyond which the pattern's detail adds at
  /// most `share` to the integral (root mean square, of the channel where it is most), if it is
  /// spread evenly over the frequencies up to `pattern_bandwidth`.
  double cutoff(double pattern_bandwidth, double share) const;

 private:
  double step_;                ///< From frequency to frequency.
  std::vector<double> above_;  ///< The squares of the frequencies from each one on, integrated.
};

/// The kernel between samples over the logarithm of the frequency.
const PointInterpolation& log_interpolation();

}  // namespace glare
