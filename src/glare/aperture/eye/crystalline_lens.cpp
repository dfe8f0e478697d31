#include "glare/aperture/eye/crystalline_lens.h"


#include "glare/base/error.h"
#include "glare/base/range_check.h"

namespace glare {

namespace {

void require_of_lens(const std::string& name, double value, double low, double high) {
  require_in_range("eye: lens." + name, value, low, high);
}

}  // namespace

void require_valid(const LensParameters& p) {
  require_of_lens("fibre_pitch_um", p.fibre_pitch_um, 5, 30);
  require_of_lens("fibre_pitch_variation", p.fibre_pitch_variation, 0.02, 0.5);
  require_of_lens("fibre_zone_inner_mm", p.fibre_zone_inner_mm, 0.5, 5);
  require_of_lens("fibre_zone_outer_mm", p.fibre_zone_outer_mm, p.fibre_zone_inner_mm * 1.05, 6);
  require_of_lens("fibre_modulation", p.fibre_modulation, 0, 1);
  require_of_lens("suture_branches", p.suture_branches, 0, 48);
  require_of_lens("suture_length_mm", p.suture_length_mm, 0.01, 5);
  require_of_lens("suture_width_um", p.suture_width_um, 0.1, 200);
  require_of_lens("suture_contrast", p.suture_contrast, 0, 1);
}

}  // namespace glare
