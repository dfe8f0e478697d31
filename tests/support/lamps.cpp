#include "support/lamps.h"

#include <cmath>
#include <vector>

namespace glare::test {

Spectrum lamp_with_narrow_lines() {
  struct Line {
    double center_nm, width_nm, power;
  };
  std::vector<double> wavelengths_nm, power;
  for (int nm = 380; nm <= 780; ++nm) {
    double sum = 0.05;
    for (const Line& line :
         {Line{404.7, 1.4, 1}, Line{435.8, 1.2, 2}, Line{486, 1.9, 1}, Line{546.1, 1.4, 4},
          Line{578, 2.8, 2}, Line{611, 2.4, 5}, Line{660, 8, 2}})
      sum += line.power * std::exp2(-4 * std::pow((nm - line.center_nm) / line.width_nm, 2));
    wavelengths_nm.push_back(nm);
    power.push_back(sum);
  }
  return Spectrum(wavelengths_nm, power);
}

Spectrum resampled(const Spectrum& spectrum, double step_nm) {
  const WavelengthRange range = spectrum.range();
  std::vector<double> wavelengths_nm, values;
  const int steps = static_cast<int>(std::lround((range.hi_nm - range.lo_nm) / step_nm));
  for (int i = 0; i <= steps; ++i) {
    wavelengths_nm.push_back(range.lo_nm + (range.hi_nm - range.lo_nm) * i / steps);
    values.push_back(spectrum(wavelengths_nm.back()));
  }
  return Spectrum(wavelengths_nm, values);
}

exact::SpectralTable table_of(const Spectrum& spectrum) {
  return {{spectrum.wavelengths_nm().begin(), spectrum.wavelengths_nm().end()},
          {spectrum.values().begin(), spectrum.values().end()}};
}

exact::Observer tables_of(const ColorMatchingFunctions& observer) {
  return {table_of(observer.x_bar), table_of(observer.y_bar), table_of(observer.z_bar)};
}

}  // namespace glare::test
