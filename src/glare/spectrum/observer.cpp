#include "glare/spectrum/observer.h"

#include <array>
#include <cmath>

#include "glare/base/embedded_file.h"
#include "glare/base/error.h"
#include "glare/spectrum/spectrum_table.h"

namespace glare {

extern const EmbeddedFile observer_files[];
extern const std::size_t observer_files_count;

namespace {

struct ObserverFile {
  const char* observer_name;
  const char* file_name;
};

constexpr std::array<ObserverFile, 4> kObservers = {{
    {"cie1931-2deg", "cie_1931_2deg.csv"},
    {"cie1964-10deg", "cie_1964_10deg.csv"},
    {"cie2015-2deg", "cie_2015_2deg.csv"},
    {"cie2015-10deg", "cie_2015_10deg.csv"},
}};

std::string_view text_of(const char* file_name) {
  for (std::size_t i = 0; i < observer_files_count; ++i)
    if (observer_files[i].name == file_name) return observer_files[i].text;
  return {};
}

ColorMatchingFunctions read_observer(const ObserverFile& file) {
  std::array<std::vector<double>, 4> columns;
  for (const auto& row : parse_number_table(text_of(file.file_name), file.file_name, 4).rows)
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].push_back(row[k]);
  return {file.observer_name, Spectrum(columns[0], columns[1]), Spectrum(columns[0], columns[2]),
          Spectrum(columns[0], columns[3])};
}

/// Simpson's rule on each interval between neighbouring knots.
template <typename Function>
double simpson(const std::vector<double>& knots, const Function& f) {
  double sum = 0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double lo = knots[i - 1], hi = knots[i];
    sum += (hi - lo) / 6 * (f(lo) + 4 * f((lo + hi) / 2) + f(hi));
  }
  return sum;
}

/// The integral of a product of two functions that are linear between the knots; Simpson's rule is
/// exact for it.
double integral_of_product(const Spectrum& a, const Spectrum& b, const WavelengthRange& range) {
  const WavelengthRange common = intersection(intersection(a.range(), b.range()), range);
  if (common.empty()) return 0;
  const std::array<const Spectrum*, 2> both = {&a, &b};
  return simpson(union_of_knots(both, common), [&](double nm) { return a(nm) * b(nm); });
}

double integral(const Spectrum& spectrum, const WavelengthRange& range) {
  const Spectrum one({range.lo_nm, range.hi_nm}, {1, 1});
  return integral_of_product(spectrum, one, range);
}

}  // namespace

std::vector<std::string> observer_names() {
  std::vector<std::string> names;
  for (const ObserverFile& observer : kObservers) names.emplace_back(observer.observer_name);
  return names;
}

const ColorMatchingFunctions& color_matching_functions(std::string_view observer_name) {
  static const std::array<ColorMatchingFunctions, kObservers.size()> observers = {
      read_observer(kObservers[0]), read_observer(kObservers[1]), read_observer(kObservers[2]),
      read_observer(kObservers[3])};
  std::string known;
  for (const ColorMatchingFunctions& observer : observers) {
    if (observer.name == observer_name) return observer;
    known += (known.empty() ? "" : ", ") + observer.name;
  }
  throw OptionError("unknown observer '" + std::string(observer_name) + "'; expected one of " +
                    known);
}

double luminous_integral(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                         const WavelengthRange& range) {
  return integral_of_product(lamp, observer.y_bar, range);
}

double effective_width_nm(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                          const WavelengthRange& range) {
  const std::array<const Spectrum*, 2> spectra = {&lamp, &observer.y_bar};
  const std::vector<double> knots_nm = union_of_knots(spectra, range);
  const auto light = [&](double nm) { return lamp(nm) * observer.y_bar(nm); };
  const double sum = simpson(knots_nm, light);
  return sum * sum / simpson(knots_nm, [&](double nm) { return light(nm) * light(nm); });
}

Xyz xyz_from_spectrum(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                      const WavelengthRange& range) {
  const double luminance = luminous_integral(lamp, observer, range);
  if (!std::isfinite(luminance)) throw InputError("lamp", "has too large a power to be summed");
  if (!(luminance > 0))
    throw InputError("lamp", "has no light that the observer sees between " +
                                 std::to_string(static_cast<int>(range.lo_nm)) + " and " +
                                 std::to_string(static_cast<int>(range.hi_nm)) + " nm");
  return {integral_of_product(lamp, observer.x_bar, range) / luminance, 1,
          integral_of_product(lamp, observer.z_bar, range) / luminance};
}

double share_of_sensitivity_missed(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                                   const WavelengthRange& range) {
  const WavelengthRange seen = intersection(observer.range(), range);
  if (seen.empty()) return 1;
  const WavelengthRange covered = intersection(seen, lamp.range());
  if (covered.empty()) return 1;
  return 1 - integral(observer.y_bar, covered) / integral(observer.y_bar, seen);
}

}  // namespace glare
