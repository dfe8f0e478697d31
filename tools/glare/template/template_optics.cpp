#include "template/template_optics.h"

#include <string>
#include <utility>

#include "glare/io/aperture_file.h"
#include "glare/template/template_eye.h"

namespace glare::tool {

TemplateOptics::TemplateOptics(const TemplateArguments& arguments, const TemplateOptions& options,
                               const Console& console)
    : arguments_(arguments), options_(options) {
  if (!arguments.has_images()) return;
  ApertureRead read = read_aperture(
      {arguments.pupil, arguments.eyelashes, arguments.width_mm, options.memory_limit_bytes});
  for (const std::string& warning : read.warnings) console.warn(warning);
  aperture_ = std::move(read.aperture);
}

void TemplateOptics::require_possible(const WavelengthRange& range) const {
  if (arguments_.has_images())
    require_far_field_possible(*aperture_, options_, range);
  else
    template_eye_size(arguments_.eye_parameters(), options_, range);
}

bool TemplateOptics::serves(const WavelengthRange& range) const {
  if (options_.aberrations.has_phase() || dark_)
    return aperture_ && (arguments_.has_images() || range_ == range);
  return far_field_ && same_far_field(*far_field_, options_, range_, range);
}

void TemplateOptics::make_far_field(const WavelengthRange& range,
                                    const ProgressCallback& progress) {
  constexpr double kShareOfAperture = 0.2;
  release_far_field();
  const bool same_eye = aperture_ && range.lo_nm == range_.lo_nm &&
                        (!options_.aberrations.has_phase() || range == range_);
  if (!arguments_.has_images() && !same_eye)
    draw_eye(range, progress_part(progress, 0, kShareOfAperture));
  dark_ = !arguments_.has_images() && energy_area_mm2(*aperture_) == 0;
  TemplateOptions options = options_;
  options.progress = progress_part(progress, kShareOfAperture, 1);
  if (!dark_ && !options_.aberrations.has_phase())
    far_field_ = template_far_field(*aperture_, options, range);
  range_ = range;
  size_ = {aperture_->transmittance.width(), aperture_->transmittance.height(),
           aperture_->pixel_mm()};
}

void TemplateOptics::draw_eye(const WavelengthRange& range, const ProgressCallback& progress) {
  release_aperture();
  TemplateOptions options = options_;
  options.progress = progress;
  aperture_ = draw_template_eye(arguments_.eye_parameters(), options, range);
}

GlareTemplate made_template(const TemplateOptics& optics, const NamedLamp& lamp,
                            const TemplateOptions& options) {
  if (optics.is_dark())
    return dark_template(optics.aperture().width_mm, lamp.spectrum, options, lamp.name);
  if (options.aberrations.has_phase())
    return make_template(optics.aperture(), lamp.spectrum, options, lamp.name);
  return make_template(optics.far_field(), lamp.spectrum, options, lamp.name);
}

}  // namespace glare::tool
