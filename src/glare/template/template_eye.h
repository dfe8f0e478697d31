// The built-in eye as a template needs it.
#pragma once

#include "glare/aperture/eye.h"
#include "glare/template/make_template.h"

namespace glare {

/// The built-in eye, drawn finely enough for a template's field of view: with half of the pixel
/// that the field needs at the shortest wavelength of `range`, so that the averaging over the pixel
/// which smooths the edges takes little from the outermost light; and never coarser than 8 um, so
/// that lashes show. Uses the options' threads, memory limit and progress. Throws `OptionError` for
/// parameters or options outside their range and a field for which the eye can't be drawn finely
/// enough, `MemoryError` where it or its template would take too much, `Cancelled`.
Aperture draw_template_eye(const EyeParameters& parameters, const TemplateOptions& options,
                           const WavelengthRange& range);

/// How large that picture is. Throws what drawing it throws, but for `Cancelled`.
ApertureSize template_eye_size(const EyeParameters& parameters, const TemplateOptions& options,
                               const WavelengthRange& range);

}  // namespace glare
