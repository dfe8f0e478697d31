#include "glare/integration/spectral_integral.h"

#include <algorithm>

#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/base/units.h"
#include "glare/integration/inner_pixels.h"
#include "glare/integration/ring_pixels.h"
#include "glare/integration/sampling_density.h"

namespace glare {

namespace {

/// The zero-padding for a pixel of that many cycles of the intensity's finest detail. Narrow pixels
/// are interpolated and need the denser samples; wide ones average over many samples.
double padding_for(double pixel_cycles) { return pixel_cycles < 1 ? kDensePadding : 3; }

/// Throws unless the field was made for pixels as far out, at the shortest wavelength.
void require_wide_enough(const FarField& field, const PixelGrid& grid,
                         const WavelengthRange& range) {
  const FarFieldRequest needed = far_field_request(field.extent_x_mm, grid, range);
  const auto holds = [](int last_sample, double frequency_per_mm, double bin_per_mm) {
    constexpr double kRounding = 1e-6;
    return last_sample - kFarFieldMargin >= frequency_per_mm / bin_per_mm - kRounding;
  };
  const int last_kx = field.first_kx + field.intensity_mm2.height() - 1;
  if (!holds(last_kx, needed.max_frequency_x_per_mm, field.bin_x_per_mm) ||
      !holds(-field.first_ky, needed.max_frequency_y_per_mm, field.bin_y_per_mm) ||
      (-field.first_kx < last_kx &&
       !holds(-field.first_kx, needed.overlap_frequency_x_per_mm, field.bin_x_per_mm)))
    throw OptionError(
        "the far field was made for a narrower field of view, other pixels or longer wavelengths");
}

}  // namespace

void spectral_integral(const FarField& field, const PixelGrid& grid, const Spectrum& lamp,
                       const ColorMatchingFunctions& observer, const WavelengthRange& range,
                       int threads, const ProgressCallback& progress, XyzImage& result) {
  xyz_from_spectrum(lamp, observer, range);  // Throws for a lamp without light.
  require_wide_enough(field, grid, range);
  for (auto& channel : result)
    if (channel.width() != grid.width || channel.height() != grid.height)
      channel = Image<float>::uninitialized(grid.width, grid.height);
  const SubPixels sub = sub_pixels(field, grid, range);
  const int ring_px = first_ring_px(field, sub, range, effective_width_nm(lamp, observer, range));
  const bool all_inner = ring_px > std::max(grid.center_x(), grid.center_y());
  const double inner_share = all_inner ? 1 : 0.1;
  integrate_inner_pixels(field, grid, ring_px, lamp, observer, range, threads,
                         progress_part(progress, 0, inner_share), result);
  if (all_inner) return;
  integrate_ring_pixels(field, grid, sub, ring_px, lamp, observer, range, threads,
                        progress_part(progress, inner_share, 1), result);
}

XyzImage spectral_integral(const FarField& field, const PixelGrid& grid, const Spectrum& lamp,
                           const ColorMatchingFunctions& observer, const WavelengthRange& range,
                           int threads, const ProgressCallback& progress) {
  XyzImage result;
  spectral_integral(field, grid, lamp, observer, range, threads, progress, result);
  return result;
}

FarFieldRequest far_field_request(double open_side_mm, const PixelGrid& grid,
                                  const WavelengthRange& range) {
  FarFieldRequest request;
  const double per_mm = grid.pitch_rad / (range.lo_nm * kMmPerNm);
  request.max_frequency_x_per_mm = (grid.center_x() + 0.5) * per_mm;
  request.max_frequency_y_per_mm = (grid.center_y() + 0.5) * per_mm;
  request.overlap_frequency_x_per_mm = 0.5 * per_mm;
  request.padding = padding_for(grid.pitch_rad / (range.hi_nm * kMmPerNm) * open_side_mm);
  return request;
}

std::uint64_t spectral_integral_bytes(double open_side_mm, const PixelGrid& grid,
                                      const WavelengthRange& range, int threads) {
  return ring_bytes(open_side_mm, grid, range, threads_used(threads));
}

}  // namespace glare
