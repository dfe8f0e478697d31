#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "glare/aperture/eye.h"
#include "glare/c/c_errors.h"
#include "glare/c/c_handles.h"
#include "glare/c/c_structures.h"
#include "glare/io/aperture_file.h"
#include "glare/io/color_config.h"
#include "glare/template/make_template.h"
#include "glare/template/template_eye.h"

namespace glare::c {

RgbColorSpace color_space_of(const char* name, const char* ocio_config) {
  const std::string wanted = name == nullptr ? lin_rec709_color_space().name() : name;
  return find_color_space(wanted, ocio_config == nullptr ? color_config_from_environment()
                                                         : std::filesystem::path(ocio_config));
}

namespace {

glare_template_options default_template_options() {
  const TemplateOptions defaults;
  const Straylight eye;
  glare_template_options o = {};
  o.struct_size = sizeof o;
  o.width = defaults.width;
  o.height = defaults.height;
  o.field_of_view_deg = defaults.field_of_view_deg;
  o.wavelength_lo_nm = defaults.wavelength_range_nm.lo_nm;
  o.wavelength_hi_nm = defaults.wavelength_range_nm.hi_nm;
  o.age_years = eye.age_years;
  o.pigment = eye.pigment;
  return o;
}

glare_eye_options default_eye_options() {
  const EyeParameters eye;
  return {sizeof(glare_eye_options), eye.pupil.diameter_mm, eye.eyelids.opening_mm, eye.time_s,
          eye.seed};
}

/// The library's options. Throws `OptionError` for a number that means nothing.
TemplateOptions template_options(const glare_template_options* given) {
  constexpr Normalization kNormalizations[] = {Normalization::peak, Normalization::energy,
                                               Normalization::absolute};
  constexpr WhiteAdaptation kWhites[] = {WhiteAdaptation::none, WhiteAdaptation::lamp};
  constexpr GamutMapping kGamuts[] = {GamutMapping::keep, GamutMapping::desaturate};
  constexpr bool kScatters[] = {false, true};
  const auto o = options_of(default_template_options(), given, "template options");
  TemplateOptions options;
  options.width = o.width;
  options.height = o.height;
  options.field_of_view_deg = o.field_of_view_deg;
  options.wavelength_range_nm = {o.wavelength_lo_nm, o.wavelength_hi_nm};
  if (o.observer != nullptr) options.observer = o.observer;
  options.color_space = color_space_of(o.color_space, o.ocio_config);
  options.white = choice(kWhites, o.white, "white");
  options.normalization = choice(kNormalizations, o.normalization, "normalization");
  options.gamut = choice(kGamuts, o.gamut, "gamut");
  if (choice(kScatters, o.scatter, "scatter")) options.scatter = Straylight{o.age_years, o.pigment};
  options.threads = threads_of(o.threads);
  options.memory_limit_bytes = limit_or_usual(o.memory_limit_bytes);
  options.progress = progress_of(o.progress, o.user);
  return options;
}

EyeParameters eye_parameters(const glare_eye_options* given) {
  const auto o = options_of(default_eye_options(), given, "eye options");
  EyeParameters eye;
  eye.pupil.diameter_mm = o.pupil_diameter_mm;
  eye.eyelids.opening_mm = o.lid_opening_mm;
  eye.time_s = o.time_s;
  eye.seed = o.seed;
  return eye;
}

/// An aperture of the caller's samples, of which the options' limit leaves room.
Aperture aperture_of(const float* transmittance, int width, int height, double width_mm) {
  constexpr int kMostSamples = 65536;
  if (width < 2 || height < 2 || width > kMostSamples || height > kMostSamples)
    throw OptionError("an aperture of " + std::to_string(width) + " x " + std::to_string(height) +
                      " samples: expected 2 to 65536 each way");
  if (!(width_mm >= 1e-3 && width_mm <= 1e6))
    throw OptionError("width_mm must be from 0.001 to 1000000");
  Aperture aperture{Image<float>::uninitialized(width, height), width_mm};
  std::copy_n(transmittance, aperture.transmittance.values().size(),
              aperture.transmittance.values().begin());
  require_valid(aperture);
  return aperture;
}

}  // namespace

}  // namespace glare::c

using namespace glare;
using namespace glare::c;

glare_status glare_template_options_init(glare_template_options* options, size_t size,
                                         glare_error* error) {
  return guarded(
      error, [&] { init_options(default_template_options(), options, size, "template options"); });
}

glare_status glare_eye_options_init(glare_eye_options* eye, size_t size, glare_error* error) {
  return guarded(error, [&] { init_options(default_eye_options(), eye, size, "eye options"); });
}

glare_status glare_template_make_eye(const glare_eye_options* eye, const glare_lamp* lamp,
                                     const glare_template_options* options, glare_template** made,
                                     glare_error* error) {
  return guarded(error, [&] {
    require_place(made, "made");
    require(lamp, "lamp");
    TemplateOptions wanted = template_options(options);
    const Spectrum& spectrum = lamp->lamp.spectrum;
    const ProgressCallback whole = wanted.progress;
    constexpr double kShareOfAperture = 0.2;
    wanted.progress = progress_part(whole, 0, kShareOfAperture);
    const Aperture drawn =
        draw_template_eye(eye_parameters(eye), wanted, effective_range(spectrum, wanted));
    wanted.progress = progress_part(whole, kShareOfAperture, 1);
    const bool is_closed = energy_area_mm2(drawn) == 0;
    *made = new glare_template{
        is_closed ? dark_template(drawn.width_mm, spectrum, wanted, lamp->lamp.name)
                  : make_template(drawn, spectrum, wanted, lamp->lamp.name)};
  });
}

glare_status glare_template_make_aperture(const float* transmittance, int32_t width, int32_t height,
                                          double width_mm, const glare_lamp* lamp,
                                          const glare_template_options* options,
                                          glare_template** made, glare_error* error) {
  return guarded(error, [&] {
    require_place(made, "made");
    require(transmittance, "transmittance");
    require(lamp, "lamp");
    const TemplateOptions wanted = template_options(options);
    *made = new glare_template{make_template(aperture_of(transmittance, width, height, width_mm),
                                             lamp->lamp.spectrum, wanted, lamp->lamp.name)};
  });
}

glare_status glare_template_make_files(const char* pupil, const char* eyelashes, double width_mm,
                                       const glare_lamp* lamp,
                                       const glare_template_options* options, glare_template** made,
                                       glare_error* error) {
  return guarded(error, [&] {
    require_place(made, "made");
    require(lamp, "lamp");
    if (pupil == nullptr && eyelashes == nullptr)
      throw OptionError("neither pupil nor eyelashes: expected one file or both");
    const TemplateOptions wanted = template_options(options);
    ApertureFiles files{
        text_or_empty(pupil), text_or_empty(eyelashes), {}, wanted.memory_limit_bytes};
    if (width_mm != 0) files.width_mm = width_mm;
    *made = new glare_template{
        make_template(read_aperture(files).aperture, lamp->lamp.spectrum, wanted, lamp->lamp.name)};
  });
}
