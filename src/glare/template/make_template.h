// From an aperture and a lamp to a glare template.
#pragma once

#include <cstdint>
#include <string>

#include "glare/aperture/aperture.h"
#include "glare/base/progress.h"
#include "glare/color/color_space.h"
#include "glare/diffraction/far_field.h"
#include "glare/integration/spectral_integral.h"
#include "glare/spectrum/spectrum.h"
#include "glare/template/glare_template.h"

namespace glare {

/// What is done with the lamp's colour.
enum class WhiteAdaptation {
  none,  ///< The template has the lamp's colour.
  lamp   ///< Adapted (Bradford), so that the lamp is the RGB space's white.
};

/// What is done with colours outside the RGB space's gamut.
enum class GamutMapping {
  keep,       ///< Nothing: channels may be negative.
  desaturate  ///< Moved towards the pixel's own grey at constant luminance.
};

struct TemplateOptions {
  int width = 512;               ///< Pixels, 1 to 65535.
  int height = 512;              ///< Pixels, 1 to 65535.
  double field_of_view_deg = 5;  ///< Across the width, in direction sine; 1e-6 to 114.
  std::string observer = "cie1931-2deg";
  WavelengthRange wavelength_range_nm = {380, 780};
  RgbColorSpace color_space = lin_rec709_color_space();
  WhiteAdaptation white = WhiteAdaptation::none;
  Normalization normalization = Normalization::peak;
  GamutMapping gamut = GamutMapping::keep;
  int threads = 0;                       ///< 0: as many as the machine has.
  std::uint64_t memory_limit_bytes = 0;  ///< 0: no limit.
  ProgressCallback progress;
};

/// The wavelengths that a template is integrated over: those of the options that the observer sees
/// and the lamp's table covers. Throws `InputError` where there are none or the lamp is dark there,
/// `OptionError` for an unknown observer or a range that is empty or that the observer doesn't see.
WavelengthRange effective_range(const Spectrum& lamp, const TemplateOptions& options);

/// The pixels' directions. Throws `OptionError` for a size or field outside its range.
PixelGrid pixel_grid(const TemplateOptions& options);

/// The widest field of view, in degrees across the width, that an aperture sampled every
/// `pixel_mm` can show for wavelengths from `shortest_nm` on: the far field of samples repeats, so
/// it reaches direction sines of +- shortest / (2 pixel). The height counts too, where it is
/// larger.
double widest_field_of_view_deg(double pixel_mm, double shortest_nm, const PixelGrid& grid);

/// The glare template of an aperture and a lamp's relative spectral power. `lamp_name` is kept in
/// the template. Throws `InputError` for an aperture or lamp that isn't valid, `OptionError` for
/// options outside their range or a field of view beyond the aperture's reach, `MemoryError` before
/// anything large is allocated, `Cancelled` when the callback says stop.
GlareTemplate make_template(const Aperture& aperture, const Spectrum& lamp,
                            const TemplateOptions& options, const std::string& lamp_name = "");

/// The same in two steps, for several lamps, observers or colour spaces on one aperture: the far
/// field holds what `options` (size, field of view) and `range` need, and serves every lamp and
/// observer whose effective range lies within `range`.
FarField template_far_field(const Aperture& aperture, const TemplateOptions& options,
                            const WavelengthRange& range);
GlareTemplate make_template(const FarField& field, const Spectrum& lamp,
                            const TemplateOptions& options, const std::string& lamp_name = "");

/// How large an aperture's picture is.
struct ApertureSize {
  int width = 0;   ///< Samples.
  int height = 0;  ///< Samples.
  double pixel_mm = 0;
};

/// Bytes that `make_template` takes at its peak, with the aperture and, in memory, the file that is
/// then made of the template. An upper bound: it takes less for an aperture with opaque margins.
std::uint64_t template_bytes(const ApertureSize& aperture, const TemplateOptions& options,
                             const WavelengthRange& range);

}  // namespace glare
