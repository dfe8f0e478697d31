// A quantity that depends on wavelength, tabulated and linear between its samples.
#pragma once

#include <span>
#include <vector>

namespace glare {

/// A closed interval of wavelengths.
struct WavelengthRange {
  double lo_nm = 0;
  double hi_nm = 0;

  bool empty() const { return !(lo_nm < hi_nm); }
  friend bool operator==(const WavelengthRange&, const WavelengthRange&) = default;
};

/// The wavelengths that both ranges hold; `empty()` where they have no interval in common.
WavelengthRange intersection(const WavelengthRange& a, const WavelengthRange& b);

/// A function of wavelength: linear between its samples and 0 outside them.
class Spectrum {
 public:
  /// Samples in any order; they are sorted. Throws `InputError` unless there are at least two, as
  /// many values as wavelengths, every wavelength finite, positive and different, and every value
  /// finite.
  Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values);

  std::span<const double> wavelengths_nm() const { return wavelengths_nm_; }
  std::span<const double> values() const { return values_; }
  WavelengthRange range() const { return {wavelengths_nm_.front(), wavelengths_nm_.back()}; }

  /// Value at a wavelength. Where the range begins or ends the sample itself is meant.
  double operator()(double wavelength_nm) const;

 private:
  std::vector<double> wavelengths_nm_;
  std::vector<double> values_;
};

/// The wavelengths in `range` at which one of the spectra has a sample, with both ends of the
/// range, ascending and without repetition: between neighbours every one of the spectra is linear.
std::vector<double> union_of_knots(std::span<const Spectrum* const> spectra,
                                   const WavelengthRange& range);

}  // namespace glare
