// The integral over wavelength for an aperture whose phase depends on wavelength. Internal.
#pragma once

#include <array>
#include <cstdint>

#include "glare/aperture/aperture.h"
#include "glare/integration/spectral_integral.h"
#include "glare/wavefront/aberrations.h"

namespace glare {

/// What light goes through. The aperture has the Stiles-Crawford effect in it already.
struct AberratedPupil {
  const Aperture& aperture;
  const Aberrations& aberrations;
};

/// As `spectral_integral`, of t exp(2 pi i W / lambda). At some wavelengths, the anchors, the phase
/// is frozen. Between them the pattern is taken for a cubic, over wavelength, of the four nearest
/// anchors' patterns, each scaled: so each anchor has a window over wavelength, the windows' sum is
/// 1, and `spectral_integral` does each anchor's with the lamp's light in its window, the windows'
/// negative lobes apart. From anchor to anchor the phases of any two places of the pupil move apart
/// by at most `kPhasePerAnchor_rad`. Throws `OptionError` where the aperture's samples are too
/// coarse for the phase, else as `spectral_integral`.
XyzImage aberrated_integral(const AberratedPupil& pupil, const PixelGrid& grid,
                            const Spectrum& lamp, const ColorMatchingFunctions& observer,
                            const WavelengthRange& range, int threads,
                            const ProgressCallback& progress);

/// docs/aberrations.md has the errors of others.
inline constexpr double kPhasePerAnchor_rad = 0.7;

/// Bytes that it takes at its peak besides the aperture, for an open part of so many samples.
std::uint64_t aberrated_integral_bytes(const std::array<int, 2>& open_size, double pixel_mm,
                                       const PixelGrid& grid, const WavelengthRange& range,
                                       int threads);

}  // namespace glare
