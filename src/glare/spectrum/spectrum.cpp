#include "glare/spectrum/spectrum.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>

#include "glare/base/error.h"

namespace glare {

namespace {

std::string nm(double wavelength_nm) {
  char text[40];
  std::snprintf(text, sizeof text, "%g nm", wavelength_nm);
  return text;
}

}  // namespace

WavelengthRange intersection(const WavelengthRange& a, const WavelengthRange& b) {
  return {std::max(a.lo_nm, b.lo_nm), std::min(a.hi_nm, b.hi_nm)};
}

Spectrum::Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values) {
  if (wavelengths_nm.size() != values.size())
    throw InputError("spectrum", "has " + std::to_string(wavelengths_nm.size()) +
                                     " wavelengths and " + std::to_string(values.size()) +
                                     " values, expected as many of both");
  if (wavelengths_nm.size() < 2)
    throw InputError("spectrum", "has fewer than two samples; at least two are needed");
  for (const double wavelength_nm : wavelengths_nm)
    if (!std::isfinite(wavelength_nm) || wavelength_nm <= 0)
      throw InputError("spectrum", "has a wavelength of " + nm(wavelength_nm) +
                                       "; wavelengths are positive numbers of nanometres");
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return wavelengths_nm[a] < wavelengths_nm[b]; });
  for (const std::size_t i : order) {
    const double wavelength_nm = wavelengths_nm[i];
    if (!std::isfinite(values[i]))
      throw InputError("spectrum", "has a value at " + nm(wavelength_nm) + " that isn't finite");
    if (!wavelengths_nm_.empty() && wavelengths_nm_.back() == wavelength_nm)
      throw InputError("spectrum", "has the wavelength " + nm(wavelength_nm) + " twice");
    wavelengths_nm_.push_back(wavelength_nm);
    values_.push_back(values[i]);
  }
}

double Spectrum::operator()(double wavelength_nm) const {
  const double first_nm = wavelengths_nm_.front(), last_nm = wavelengths_nm_.back();
  if (!(wavelength_nm >= first_nm && wavelength_nm <= last_nm)) return 0;
  if (wavelength_nm == last_nm) return values_.back();
  // Most tables are evenly spaced: the interval is where it then would be, or is searched for.
  const std::size_t intervals = values_.size() - 1;
  const double place =
      (wavelength_nm - first_nm) / (last_nm - first_nm) * static_cast<double>(intervals);
  std::size_t i = std::min(static_cast<std::size_t>(place), intervals - 1);
  if (!(wavelengths_nm_[i] <= wavelength_nm && wavelength_nm < wavelengths_nm_[i + 1]))
    i = static_cast<std::size_t>(
            std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end(), wavelength_nm) -
            wavelengths_nm_.begin()) -
        1;
  const double share =
      (wavelength_nm - wavelengths_nm_[i]) / (wavelengths_nm_[i + 1] - wavelengths_nm_[i]);
  return std::lerp(values_[i], values_[i + 1], share);
}

std::vector<double> union_of_knots(std::span<const Spectrum* const> spectra,
                                   const WavelengthRange& range) {
  std::vector<double> knots = {range.lo_nm, range.hi_nm};
  for (const Spectrum* spectrum : spectra)
    for (const double wavelength_nm : spectrum->wavelengths_nm())
      if (wavelength_nm > range.lo_nm && wavelength_nm < range.hi_nm)
        knots.push_back(wavelength_nm);
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  return knots;
}

}  // namespace glare
