#include "glare/wavefront/aberrations.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "glare/base/error.h"
#include "glare/base/range_check.h"
#include "glare/wavefront/wavefront_map.h"

namespace glare {

namespace {

constexpr double kMost_dioptre = 50, kMost_um = 1000, kMostOffCenter_mm = 100;

template <typename... Numbers>
std::string text_of(const char* format, Numbers... numbers) {
  char text[160];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

void require_of_aberrations(const std::string& name, double value, double low, double high) {
  require_in_range("aberrations: " + name, value, low, high);
}

void require_valid(const ZernikeWavefront& zernike) {
  if (zernike.coefficients.empty()) return;
  require_of_aberrations("the Zernike polynomials' pupil diameter (mm)", zernike.pupil_diameter_mm,
                         0.1, 50);
  std::set<int> seen;
  for (const ZernikeCoefficient& term : zernike.coefficients) {
    require_of_aberrations("a Zernike index j", term.j, 0, highest_zernike_j());
    require_of_aberrations("a Zernike coefficient (um)", term.value_um, -kMost_um, kMost_um);
    if (!seen.insert(term.j).second)
      throw OptionError(text_of("aberrations: the Zernike index %d is there twice", term.j));
  }
}

void append(std::string& text, const std::string& part) {
  text += (text.empty() ? "" : "; ") + part;
}

}  // namespace

bool Aberrations::has_phase() const {
  return defocus_dioptre != 0 || chromatic ||
         std::ranges::any_of(zernike.coefficients, [](const ZernikeCoefficient& term) {
           return term.j != 0 && term.value_um != 0;
         });
}

void require_valid(const Aberrations& a) {
  require_of_aberrations("the defocus (dioptres)", a.defocus_dioptre, -kMost_dioptre,
                         kMost_dioptre);
  require_valid(a.zernike);
  require_of_aberrations("the wavelength in focus (nm)", a.focused_nm, 300, 1000);
  require_of_aberrations("the pupil's centre (mm)", a.pupil_center.x_mm, -kMostOffCenter_mm,
                         kMostOffCenter_mm);
  require_of_aberrations("the pupil's centre (mm)", a.pupil_center.y_mm, -kMostOffCenter_mm,
                         kMostOffCenter_mm);
  if (!a.stiles_crawford) return;
  require_of_aberrations("Stiles-Crawford's rho (per mm^2)", a.stiles_crawford->rho_per_mm2, 0, 1);
  require_of_aberrations("the Stiles-Crawford peak (mm)", a.stiles_crawford->peak.x_mm, -10, 10);
  require_of_aberrations("the Stiles-Crawford peak (mm)", a.stiles_crawford->peak.y_mm, -10, 10);
}

double chromatic_refraction_dioptre(double wavelength_nm) {
  constexpr double p = 1.68524, q = 633.46, c_nm = 214.102;
  return p - q / (wavelength_nm - c_nm);
}

double chromatic_difference_dioptre(const Aberrations& a, double wavelength_nm) {
  if (!a.chromatic) return 0;
  return chromatic_refraction_dioptre(wavelength_nm) - chromatic_refraction_dioptre(a.focused_nm);
}

double optical_path_um(const Aberrations& a, const PupilPlace& place, double wavelength_nm) {
  const double square_mm2 = place.x_mm * place.x_mm + place.y_mm * place.y_mm;
  const double refraction_dioptre =
      a.defocus_dioptre + chromatic_difference_dioptre(a, wavelength_nm);
  const double radius_mm = a.zernike.pupil_diameter_mm / 2;
  const double higher_um =
      a.zernike.coefficients.empty()
          ? 0
          : ZernikeSum(a.zernike.coefficients)(place.x_mm / radius_mm, place.y_mm / radius_mm);
  return -refraction_dioptre * square_mm2 / 2 + higher_um;
}

Aperture apodized(Aperture aperture, const StilesCrawford& effect, const PupilPlace& pupil_center) {
  Image<float>& t = aperture.transmittance;
  const PupilGrid grid(aperture, pupil_center);
  // 10^(-rho r^2 / 2) is a product over x and y.
  const auto along = [&](double distance_mm) {
    return std::pow(10.0, -effect.rho_per_mm2 * distance_mm * distance_mm / 2);
  };
  std::vector<double> of_column;
  for (int x = 0; x < t.width(); ++x) of_column.push_back(along(grid.x_mm(x) - effect.peak.x_mm));
  double energy_before = 0, energy_after = 0;
  for (int y = 0; y < t.height(); ++y) {
    const double of_row = along(grid.y_mm(y) - effect.peak.y_mm);
    auto row = t.row(y);
    for (std::size_t x = 0; x < row.size(); ++x) {
      energy_before += double{row[x]} * row[x];
      row[x] = static_cast<float>(row[x] * (of_row * of_column[x]));
      energy_after += double{row[x]} * row[x];
    }
  }
  if (aperture.unlimited_energy_area_mm2 && energy_before > 0)
    *aperture.unlimited_energy_area_mm2 *= energy_after / energy_before;
  return aperture;
}

std::string to_string(const Aberrations& a) {
  std::string text;
  if (a.defocus_dioptre != 0) append(text, text_of("defocus %g D", a.defocus_dioptre));
  if (!a.zernike.coefficients.empty()) {
    std::string terms;
    for (const ZernikeCoefficient& term : a.zernike.coefficients)
      terms += text_of(" %d:%g", term.j, term.value_um);
    append(text,
           text_of("Zernike (OSA/ANSI j:um) over %g mm", a.zernike.pupil_diameter_mm) + terms);
  }
  if (a.chromatic)
    append(text, text_of("chromatic aberration (Thibos 1992), %g nm in focus", a.focused_nm));
  if (const auto& effect = a.stiles_crawford)
    append(text, text_of("Stiles-Crawford %g/mm2, peak at %g, %g mm", effect->rho_per_mm2,
                         effect->peak.x_mm, effect->peak.y_mm));
  if (!text.empty() && (a.pupil_center.x_mm != 0 || a.pupil_center.y_mm != 0))
    append(text, text_of("pupil's centre at %g, %g mm", a.pupil_center.x_mm, a.pupil_center.y_mm));
  return text;
}

}  // namespace glare
