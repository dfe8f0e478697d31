#include "glare/integration/aberrated_integral.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <vector>

#include "glare/base/error.h"
#include "glare/diffraction/complex_far_field.h"
#include "glare/wavefront/wavefront_map.h"

namespace glare {

namespace {

constexpr int kMostAnchors = 4000;

/// A wavelength at which the phase is frozen, and its hat: 1 there, 0 at its neighbours.
struct Anchor {
  double wavelength_nm;
  WavelengthRange window;
};

void require_fine_enough(const WavefrontMap& map, double pixel_mm, const WavelengthRange& range) {
  const double step_rad = map.largest_phase_step_rad(range);
  if (step_rad <= std::numbers::pi) return;
  char text[220];
  std::snprintf(text, sizeof text,
                "the aberrations move the phase by %.3g rad from one aperture pixel of %.4g um to "
                "the next, expected at most pi: give an aperture with pixels of at most %.3g um",
                step_rad, pixel_mm * 1e3, pixel_mm * 1e3 * 0.99 * std::numbers::pi / step_rad);
  throw OptionError(text);
}

/// Wavelengths from one end of the range to the other between which the phase moves about alike; a
/// single one where it hardly moves at all.
std::vector<double> anchor_wavelengths_nm(const WavefrontMap& map, const WavelengthRange& range) {
  constexpr int kSteps = 400;
  constexpr double kNone_rad = 1e-3;
  const auto at = [&](int i) { return range.lo_nm + (range.hi_nm - range.lo_nm) * i / kSteps; };
  std::vector<double> moved_rad = {0};
  for (int i = 1; i <= kSteps; ++i)
    moved_rad.push_back(moved_rad.back() + map.phase_spread_rad(at(i - 1), at(i)));
  const double all_rad = moved_rad.back();
  if (all_rad < kNone_rad) return {(range.lo_nm + range.hi_nm) / 2};
  const double intervals = std::ceil(all_rad / kPhasePerAnchor_rad);
  if (intervals > kMostAnchors)
    throw OptionError("the aberrations are too large: the phase moves by " +
                      std::to_string(static_cast<long long>(all_rad)) +
                      " rad over the wavelengths, expected at most " +
                      std::to_string(static_cast<int>(kMostAnchors * kPhasePerAnchor_rad)));
  std::vector<double> result = {range.lo_nm};
  for (int k = 1; k < static_cast<int>(intervals); ++k) {
    const double wanted = all_rad * k / intervals;
    const auto after = std::upper_bound(moved_rad.begin(), moved_rad.end(), wanted);
    const auto i = static_cast<int>(after - moved_rad.begin());
    const double before = *std::prev(after);
    const double share = (wanted - before) / (*after - before);
    result.push_back(at(i - 1) + share * (at(i) - at(i - 1)));
  }
  result.push_back(range.hi_nm);
  return result;
}

std::vector<Anchor> anchors(const std::vector<double>& wavelengths_nm,
                            const WavelengthRange& range) {
  std::vector<Anchor> result;
  for (std::size_t i = 0; i < wavelengths_nm.size(); ++i)
    result.push_back({wavelengths_nm[i],
                      {i == 0 ? range.lo_nm : wavelengths_nm[i - 1],
                       i + 1 == wavelengths_nm.size() ? range.hi_nm : wavelengths_nm[i + 1]}});
  return result;
}

/// The lamp's light times an anchor's hat, sampled so densely that it may be linear between.
Spectrum windowed(const Spectrum& lamp, const Anchor& anchor, bool alone) {
  constexpr int kParts = 16;  // Of each side: a parabola is then within 1/1000 of its height.
  const WavelengthRange& window = anchor.window;
  std::vector<double> knots_nm = {window.lo_nm, anchor.wavelength_nm, window.hi_nm};
  for (int k = 1; k < kParts; ++k) {
    knots_nm.push_back(std::lerp(window.lo_nm, anchor.wavelength_nm, double(k) / kParts));
    knots_nm.push_back(std::lerp(anchor.wavelength_nm, window.hi_nm, double(k) / kParts));
  }
  for (const double nm : lamp.wavelengths_nm())
    if (nm > window.lo_nm && nm < window.hi_nm) knots_nm.push_back(nm);
  std::sort(knots_nm.begin(), knots_nm.end());
  knots_nm.erase(std::unique(knots_nm.begin(), knots_nm.end()), knots_nm.end());
  std::vector<double> power;
  for (const double nm : knots_nm) {
    const double edge_nm = nm < anchor.wavelength_nm ? window.lo_nm : window.hi_nm;
    const double hat =
        alone || nm == anchor.wavelength_nm ? 1 : (nm - edge_nm) / (anchor.wavelength_nm - edge_nm);
    power.push_back(lamp(nm) * hat);
  }
  return Spectrum(std::move(knots_nm), std::move(power));
}

void add(const XyzImage& part, double share, XyzImage& sum) {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto source = part[c].values();
    const auto target = sum[c].values();
    for (std::size_t i = 0; i < source.size(); ++i)
      target[i] += static_cast<float>(share) * source[i];
  }
}

/// One anchor's light, added to the sum.
class AnchorIntegral {
 public:
  AnchorIntegral(const AberratedPupil& pupil, const WavefrontMap& map, const PixelGrid& grid,
                 const ColorMatchingFunctions& observer, int threads)
      : map_(map), grid_(grid), observer_(observer), threads_(threads) {
    part_ = {map.part().width,
             map.part().height,
             pupil.aperture.pixel_mm(),
             energy_area_mm2(pupil.aperture),
             {}};
  }

  void add_to(XyzImage& sum, const Anchor& anchor, const Spectrum& light, double share,
              const ProgressCallback& progress) {
    part_.row = [&](int y, std::span<std::complex<float>> row) {
      map_.amplitude_row(y, anchor.wavelength_nm, row);
    };
    FarFieldRequest request = far_field_request(
        std::min(part_.width, part_.height) * part_.pixel_mm, grid_, anchor.window);
    request.threads = threads_;
    request.progress = progress_part(progress, 0, 0.6);
    const FarFieldParts field = complex_far_field(part_, request);
    const auto integrate = [&](const FarField& f, double from, double to) {
      spectral_integral(f, grid_, light, observer_, anchor.window, threads_,
                        progress_part(progress, from, to), picture_);
      add(picture_, share, sum);
    };
    integrate(field.even, 0.6, 0.8);
    integrate(field.odd, 0.8, 1);
  }

 private:
  const WavefrontMap& map_;
  const PixelGrid& grid_;
  const ColorMatchingFunctions& observer_;
  int threads_;
  ComplexOpenPart part_;
  XyzImage picture_;
};

}  // namespace

XyzImage aberrated_integral(const AberratedPupil& pupil, const PixelGrid& grid,
                            const Spectrum& lamp, const ColorMatchingFunctions& observer,
                            const WavelengthRange& range, int threads,
                            const ProgressCallback& progress) {
  constexpr double kDarkest = 1e-9;  // Of all the light: what less adds to a pixel is not seen.
  const WavefrontMap map(pupil.aperture, pupil.aberrations, threads);
  require_fine_enough(map, pupil.aperture.pixel_mm(), range);
  const std::vector<Anchor> all = anchors(anchor_wavelengths_nm(map, range), range);
  const double luminance = luminous_integral(lamp, observer, range);
  XyzImage sum;
  sum.fill(Image<float>(grid.width, grid.height));
  AnchorIntegral integral(pupil, map, grid, observer, threads);
  const auto count = static_cast<double>(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Spectrum light = windowed(lamp, all[i], all.size() == 1);
    const double share = luminous_integral(light, observer, all[i].window) / luminance;
    const auto done = static_cast<double>(i);
    if (share > kDarkest)
      integral.add_to(sum, all[i], light, share,
                      progress_part(progress, done / count, (done + 1) / count));
  }
  return sum;
}

std::uint64_t aberrated_integral_bytes(const std::array<int, 2>& open_size, double pixel_mm,
                                       const PixelGrid& grid, const WavelengthRange& range,
                                       int threads) {
  const auto [width, height] = open_size;
  // A window at the blue end reaches as far as the range, and one at the red end may be padded
  // more.
  FarFieldRequest request = far_field_request(std::min(width, height) * pixel_mm, grid, range);
  request.padding = std::max(request.padding, 4.0);
  request.threads = threads;
  constexpr std::uint64_t kPictures = 6;
  return WavefrontMap::bytes(width, height) +
         complex_far_field_bytes(width, height, pixel_mm, request) +
         kPictures * sizeof(float) * static_cast<std::uint64_t>(grid.width) *
             static_cast<std::uint64_t>(grid.height) +
         spectral_integral_bytes(std::max(width, height) * pixel_mm, grid, range, threads);
}

}  // namespace glare
