#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "glare/c/c_errors.h"
#include "glare/c/c_handles.h"
#include "glare/c/c_pixels.h"
#include "glare/c/c_structures.h"
#include "glare/io/template_file.h"

using namespace glare;
using namespace glare::c;

namespace {

int32_t number_of(Normalization normalization) {
  switch (normalization) {
    case Normalization::energy:
      return GLARE_NORMALIZE_ENERGY;
    case Normalization::absolute:
      return GLARE_NORMALIZE_ABSOLUTE;
    case Normalization::peak:
      break;
  }
  return GLARE_NORMALIZE_PEAK;
}

glare_template_facts facts_of(const GlareTemplate& t) {
  glare_template_facts facts = {};
  facts.width = t.width();
  facts.height = t.height();
  facts.center_x = t.center_px()[0];
  facts.center_y = t.center_px()[1];
  facts.pixel_pitch_deg = t.pixel_pitch_deg();
  facts.pixel_pitch_rad = t.pixel_pitch_rad;
  facts.per_steradian = t.per_steradian;
  facts.captured_energy = t.captured_energy;
  facts.scattered_energy = t.scattered_energy;
  std::copy(t.lamp_xyz.begin(), t.lamp_xyz.end(), facts.lamp_xyz);
  std::copy(t.light_xyz.begin(), t.light_xyz.end(), facts.light_xyz);
  facts.wavelength_lo_nm = t.wavelength_range_nm.lo_nm;
  facts.wavelength_hi_nm = t.wavelength_range_nm.hi_nm;
  facts.aperture_width_mm = t.aperture_width_mm;
  facts.aperture_area_mm2 = t.aperture_area_mm2;
  facts.normalization = number_of(t.normalization);
  facts.has_scatter = t.scatter.has_value() ? 1 : 0;
  return facts;
}

}  // namespace

glare_status glare_template_read(const char* path, glare_template** read, glare_error* error) {
  return guarded(error, [&] {
    require_place(read, "read");
    require(path, "path");
    *read = new glare_template{read_template(path, {limit_or_usual(0)})};
  });
}

glare_status glare_template_write(const glare_template* of, const char* path, int32_t half,
                                  glare_error* error) {
  return guarded(error, [&] {
    require(of, "of");
    require(path, "path");
    TemplateFileOptions options;
    options.half = half != 0;
    write_template(path, of->value, options);
  });
}

void glare_template_free(glare_template* made) { delete made; }

glare_status glare_template_get_facts(const glare_template* of, glare_template_facts* facts,
                                      size_t size, glare_error* error) {
  return guarded(error, [&] {
    require(of, "of");
    give_structure(facts_of(of->value), facts, size, "facts");
  });
}

glare_status glare_template_text(const glare_template* of, int32_t which, char* buffer, size_t size,
                                 size_t* needed, glare_error* error) {
  return guarded(error, [&] {
    require(of, "of");
    const GlareTemplate& t = of->value;
    const std::string* const texts[] = {&t.lamp, &t.observer, &t.color_space.name(), &t.recipe,
                                        &t.software};
    give_text(*choice(texts, which, "which"), buffer, size, needed);
  });
}

glare_status glare_template_set_recipe(glare_template* of, const char* recipe, glare_error* error) {
  return guarded(error, [&] {
    require(of, "of");
    require(recipe, "recipe");
    of->value.recipe = recipe;
  });
}

glare_status glare_template_copy_pixels(const glare_template* of, const glare_pixels* pixels,
                                        glare_error* error) {
  return guarded(error, [&] {
    require(of, "of");
    require(pixels, "pixels");
    require_valid(*pixels);
    const GlareTemplate& t = of->value;
    if (pixels->width != t.width() || pixels->height != t.height() || pixels->channels != 3)
      throw OptionError("the pixels must be " + std::to_string(t.width()) + " x " +
                        std::to_string(t.height()) + " of 3 channels");
    copy_channels(t.channels, *pixels);
  });
}
