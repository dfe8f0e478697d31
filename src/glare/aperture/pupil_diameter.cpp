#include "glare/aperture/pupil_diameter.h"

#include <cmath>
#include <cstdio>

#include "glare/base/error.h"

namespace glare {

namespace {

[[noreturn]] void refuse(const char* name, double value, const char* expected) {
  char text[160];
  std::snprintf(text, sizeof text, "adaptation: %s is %g, expected %s", name, value, expected);
  throw OptionError(text);
}

void require_valid(const Adaptation& a) {
  if (!(a.luminance_cd_m2 >= 0 && a.luminance_cd_m2 <= 1e6))
    refuse("luminance_cd_m2", a.luminance_cd_m2, "0 to 1e6");
  if (!(a.field_area_deg2 > 0 && a.field_area_deg2 <= 41253))
    refuse("field_area_deg2", a.field_area_deg2, "above 0 to 41253");
  if (!(a.age_years >= 20 && a.age_years <= 83)) refuse("age_years", a.age_years, "20 to 83");
  if (a.eyes != 1 && a.eyes != 2) refuse("eyes", a.eyes, "1 or 2");
}

double stanley_davies_diameter_mm(double corneal_flux_density) {
  const double response = std::pow(corneal_flux_density / 846, 0.41);
  return 7.75 - 5.75 * response / (response + 2);
}

}  // namespace

double pupil_diameter_mm(const Adaptation& a) {
  constexpr double reference_age = 28.58, one_eye = 0.1;
  require_valid(a);
  const double seen_by = a.eyes == 1 ? one_eye : 1;
  const double d = stanley_davies_diameter_mm(a.luminance_cd_m2 * a.field_area_deg2 * seen_by);
  return d + (a.age_years - reference_age) * (0.02132 - 0.009562 * d);
}

}  // namespace glare
