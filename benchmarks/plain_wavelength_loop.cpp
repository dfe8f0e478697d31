#include "plain_wavelength_loop.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "glare/base/units.h"

namespace glare::bench {

namespace {

struct Wavelength {
  double nm;
  std::array<float, 3> weights;
};

std::vector<Wavelength> evenly_spaced(const Spectrum& lamp, const ColorMatchingFunctions& observer,
                                      const WavelengthRange& range, int count) {
  const double step_nm = (range.hi_nm - range.lo_nm) / count;
  double luminance = 0;
  for (int i = 0; i < count; ++i) {
    const double nm = range.lo_nm + (i + 0.5) * step_nm;
    luminance += lamp(nm) * observer.y_bar(nm);
  }
  std::vector<Wavelength> out;
  for (int i = 0; i < count; ++i) {
    const double nm = range.lo_nm + (i + 0.5) * step_nm;
    const double light = lamp(nm) / luminance / std::pow(nm * kMmPerNm, 2);
    out.push_back({nm,
                   {static_cast<float>(light * observer.x_bar(nm)),
                    static_cast<float>(light * observer.y_bar(nm)),
                    static_cast<float>(light * observer.z_bar(nm))}});
  }
  return out;
}

/// Where each pixel of a row or column lies among the samples.
struct Places {
  std::vector<int> before;   ///< The sample before it.
  std::vector<float> share;  ///< How far it is on the way to the next.

  Places(int pixels, int center_px, double samples_per_pixel, int center_sample) {
    for (int i = 0; i < pixels; ++i) {
      const double place = (i - center_px) * samples_per_pixel + center_sample;
      before.push_back(static_cast<int>(std::floor(place)));
      share.push_back(static_cast<float>(place - std::floor(place)));
    }
  }
};

}  // namespace

PlainFarField plain_far_field(const FarField& field) {
  const int last_kx = field.first_kx + field.intensity_mm2.height() - 1;
  const int last_ky = -field.first_ky;
  PlainFarField out{Image<float>(2 * last_kx + 1, 2 * last_ky + 1), last_kx, last_ky,
                    field.bin_x_per_mm, field.bin_y_per_mm};
  for (int kx = 0; kx <= last_kx; ++kx)
    for (int ky = -last_ky; ky <= last_ky; ++ky) {
      const float value = field.intensity_mm2(ky - field.first_ky, kx - field.first_kx);
      out.intensity_mm2(out.center_x + kx, out.center_y + ky) = value;
      out.intensity_mm2(out.center_x - kx, out.center_y - ky) = value;
    }
  return out;
}

XyzImage plain_wavelength_loop(const PlainFarField& field, const PixelGrid& grid,
                               const Spectrum& lamp, const ColorMatchingFunctions& observer,
                               const WavelengthRange& range, int wavelengths) {
  XyzImage image;
  for (auto& channel : image) channel = Image<float>(grid.width, grid.height);
  for (const Wavelength& wavelength : evenly_spaced(lamp, observer, range, wavelengths)) {
    const double pixel_per_mm = grid.pitch_rad / (wavelength.nm * kMmPerNm);
    const Places columns(grid.width, grid.center_x(), pixel_per_mm / field.bin_x_per_mm,
                         field.center_x);
    const Places rows(grid.height, grid.center_y(), pixel_per_mm / field.bin_y_per_mm,
                      field.center_y);
    const auto [weight_x, weight_y, weight_z] = wavelength.weights;
    for (int y = 0; y < grid.height; ++y) {
      const float* const upper = field.intensity_mm2.row(rows.before[y]).data();
      const float* const lower = field.intensity_mm2.row(rows.before[y] + 1).data();
      const float down = rows.share[y];
      float* const out_x = image[0].row(y).data();
      float* const out_y = image[1].row(y).data();
      float* const out_z = image[2].row(y).data();
      for (int x = 0; x < grid.width; ++x) {
        const int before = columns.before[x];
        const float right = columns.share[x];
        const float left_value = upper[before] + down * (lower[before] - upper[before]);
        const float right_value =
            upper[before + 1] + down * (lower[before + 1] - upper[before + 1]);
        const float value = left_value + right * (right_value - left_value);
        out_x[x] += weight_x * value;
        out_y[x] += weight_y * value;
        out_z[x] += weight_z * value;
      }
    }
  }
  return image;
}

}  // namespace glare::bench
