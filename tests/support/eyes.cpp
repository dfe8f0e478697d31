#include "support/eyes.h"

namespace glare {

EyeParameters clear_eye() {
  EyeParameters parameters;
  parameters.particles.cornea.number_per_mm2 = 0;
  parameters.particles.lens.number_per_mm2 = 0;
  parameters.particles.vitreous.number_per_mm2 = 0;
  parameters.lens.fibre_modulation = parameters.lens.suture_contrast = 0;
  return parameters;
}

EyeParameters bare_pupil() {
  EyeParameters parameters = clear_eye();
  parameters.eyelids.opening_mm = 12;
  parameters.upper_lashes.count = parameters.lower_lashes.count = 0;
  return parameters;
}

EyeParameters round_pupil() {
  EyeParameters p = bare_pupil();
  p.pupil.axis_ratio = 1;
  p.pupil.crypt_irregularity_mm = p.pupil.ruff_irregularity_mm = 0;
  p.pupil.decentring_x_mm = p.pupil.decentring_y_mm = 0;
  return p;
}

}  // namespace glare
