// From an aperture and a lamp to a glare template.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "glare/aperture/aperture.h"
#include "glare/base/progress.h"
#include "glare/color/color_space.h"
#include "glare/diffraction/far_field.h"
#include "glare/integration/spectral_integral.h"
#include "glare/scatter/straylight.h"
#include "glare/spectrum/spectrum.h"
#include "glare/template/glare_template.h"
#include "glare/wavefront/aberrations.h"

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
  /// The eye whose straylight is added; none: diffraction alone. With it a template is
  /// (1 - s) diffraction + S, per steradian: S in the lamp's colour, and s its share of the light.
  std::optional<Straylight> scatter;
  RgbColorSpace color_space = lin_rec709_color_space();
  WhiteAdaptation white = WhiteAdaptation::none;
  Normalization normalization = Normalization::peak;
  GamutMapping gamut = GamutMapping::keep;
  /// Of the eye. What shifts the phase depends on wavelength, so that no one far field serves all:
  /// only the one-step `make_template` takes it, and the two-step functions throw `OptionError`.
  Aberrations aberrations;
  int threads = 0;                       ///< 0: as many as the machine has.
  std::uint64_t memory_limit_bytes = 0;  ///< 0: no limit.
  std::uint64_t further_bytes = 0;       ///< What the caller takes beside, within the limit.
  ProgressCallback progress;
};

/// The wavelengths that a template is integrated over: those of the options that the observer sees
/// and the lamp's table covers. Throws `InputError` where there are none or the lamp is dark there,
/// `OptionError` for an unknown observer or a range that is empty or that the observer doesn't see.
WavelengthRange effective_range(const Spectrum& lamp, const TemplateOptions& options);

/// The least range that holds every lamp's effective range. Throws as for one lamp; `InputError`
/// where there is no lamp.
WavelengthRange effective_range(std::span<const Spectrum> lamps, const TemplateOptions& options);

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

/// The template of a closed eye: black, of no area and no captured light, with a scale of 1.
GlareTemplate dark_template(double aperture_width_mm, const Spectrum& lamp,
                            const TemplateOptions& options, const std::string& lamp_name = "");

/// The same in two steps, for several lamps, observers, colour spaces, normalisations and so on, on
/// one aperture: only the first, with its Fourier transform, needs the aperture.
///
///   const WavelengthRange range = effective_range(lamps, options);
///   const FarField field = template_far_field(aperture, options, range);
///   for (const Spectrum& lamp : lamps) use(make_template(field, lamp, options));
///
/// The far field holds what `options` (size, field of view) and `range` need, and serves every lamp
/// and observer whose effective range lies within `range`; `OptionError` for another. Each template
/// is the one-step one to the accuracy of the integral, and to the last bit where `same_far_field`
/// holds for `range` and the lamp's own.
FarField template_far_field(const Aperture& aperture, const TemplateOptions& options,
                            const WavelengthRange& range);
GlareTemplate make_template(const FarField& field, const Spectrum& lamp,
                            const TemplateOptions& options, const std::string& lamp_name = "");

/// Throws what `template_far_field` throws before it begins: `InputError` for an aperture that
/// isn't valid, `OptionError` beyond its reach, `MemoryError`.
void require_far_field_possible(const Aperture& aperture, const TemplateOptions& options,
                                const WavelengthRange& range);

/// True where a far field made for the range `made_for` is, to the last bit, the one for `range`:
/// where both begin together, unless one ends so much later that its patterns need finer samples.
bool same_far_field(const FarField& field, const TemplateOptions& options,
                    const WavelengthRange& made_for, const WavelengthRange& range);

/// How large an aperture's picture is.
struct ApertureSize {
  int width = 0;   ///< Samples.
  int height = 0;  ///< Samples.
  double pixel_mm = 0;
};

/// Bytes that `make_template` takes at its peak, with the aperture, the writing of the template to
/// a file, and the options' `further_bytes`. An upper bound: it takes less for an aperture with
/// opaque margins.
std::uint64_t template_bytes(const ApertureSize& aperture, const TemplateOptions& options,
                             const WavelengthRange& range);

/// Throws `MemoryError` where that is more than the options' limit.
void require_memory(const ApertureSize& aperture, const TemplateOptions& options,
                    const WavelengthRange& range);

}  // namespace glare
