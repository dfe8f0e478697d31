#include "template/template_notes.h"

#include <cstdio>

#include "glare/spectrum/observer.h"

namespace glare::tool {

std::optional<std::string> missed_light(const NamedLamp& lamp, const TemplateOptions& options) {
  constexpr double kMuch = 0.01;
  const double missed = share_of_sensitivity_missed(
      lamp.spectrum, color_matching_functions(options.observer), options.wavelength_range_nm);
  if (missed <= kMuch) return std::nullopt;
  const WavelengthRange covered = lamp.spectrum.range();
  char text[120];
  std::snprintf(text, sizeof text,
                "%g to %g nm, misses %.1f %% of what the observer sees (by luminous efficiency)",
                covered.lo_nm, covered.hi_nm, 100 * missed);
  return "lamp " + lamp.name + ": its table, " + text;
}

/// Half precision has full digits down to 6.1e-5; a template's outskirts are often darker.
void warn_of_lost_digits(const std::string& file, const GlareTemplate& glare_template,
                         const Console& console) {
  constexpr double kSmallestNormal = 6.1e-5;
  std::size_t dark = 0;
  const int width = glare_template.width(), height = glare_template.height();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) dark += glare_template.luminance(x, y) < kSmallestNormal;
  const double share = static_cast<double>(dark) / (static_cast<double>(width) * height);
  if (share < 0.01) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "--half: %.0f %% of the pixels are darker than 6.1e-5, where half precision loses "
                "digits and then the light itself",
                100 * share);
  console.warn(file + ": " + text);
}

void tell_what_was_made(const std::string& file, const GlareTemplate& t,
                        const ApertureSize& aperture, const Console& console) {
  char text[240];
  std::snprintf(text, sizeof text,
                "aperture %d x %d samples of %.4g um, template %d x %d pixels of %.4g degrees, "
                "%.4g %% of the light, 1 is %.6g per steradian",
                aperture.width, aperture.height, aperture.pixel_mm * 1e3, t.width(), t.height(),
                t.pixel_pitch_deg(), 100 * t.captured_energy, t.per_steradian);
  console.tell(file + ": lamp " + t.lamp + ", " + text);
}

}  // namespace glare::tool
