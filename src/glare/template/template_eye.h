// The built-in eye as a template needs it.
#pragma once

#include "glare/aperture/eye.h"
#include "glare/template/make_template.h"

namespace glare {

/// The built-in eye as samples of its band-limited transmittance (see `Aperture`), somewhat finer
/// than the field of view needs at the shortest wavelength of `range`, and never coarser than 5 um,
/// so that lashes show. They are filtered from a picture with four times as many samples each way:
/// so the far field is the drawn eye's, right up to the rim of the field, and the template is the
/// same at every number of pixels. An eye whose lids are closed gives an opaque picture, of which
/// no template can be made.
///
/// Uses the options' threads, memory limit and progress. Throws `OptionError` for parameters or
/// options outside their range and a field for which the eye can't be drawn finely enough,
/// `MemoryError` where it or its template would take too much, `Cancelled`.
Aperture draw_template_eye(const EyeParameters& parameters, const TemplateOptions& options,
                           const WavelengthRange& range);

/// How large that picture is. Throws what drawing it throws, but for `Cancelled`.
ApertureSize template_eye_size(const EyeParameters& parameters, const TemplateOptions& options,
                               const WavelengthRange& range);

}  // namespace glare
