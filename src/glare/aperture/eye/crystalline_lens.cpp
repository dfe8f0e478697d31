#include "glare/aperture/eye/crystalline_lens.h"

#include <cstdio>

#include "glare/base/error.h"

namespace glare {

namespace {

void require_in_range(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  char text[160];
  std::snprintf(text, sizeof text, "eye: lens.%s is %g, expected %g to %g", name, value, low, high);
  throw OptionError(text);
}

}  // namespace

void require_valid(const LensParameters& p) {
  require_in_range("fibre_pitch_um", p.fibre_pitch_um, 5, 30);
  require_in_range("fibre_pitch_variation", p.fibre_pitch_variation, 0.02, 0.5);
  require_in_range("fibre_zone_inner_mm", p.fibre_zone_inner_mm, 0.5, 5);
  require_in_range("fibre_zone_outer_mm", p.fibre_zone_outer_mm, p.fibre_zone_inner_mm * 1.05, 6);
  require_in_range("fibre_modulation", p.fibre_modulation, 0, 1);
  require_in_range("suture_branches", p.suture_branches, 0, 48);
  require_in_range("suture_length_mm", p.suture_length_mm, 0.01, 5);
  require_in_range("suture_width_um", p.suture_width_um, 0.1, 200);
  require_in_range("suture_contrast", p.suture_contrast, 0, 1);
}

}  // namespace glare
