#include "glare/integration/aberrated_integral.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "glare/base/error.h"
#include "glare/diffraction/complex_far_field.h"
#include "glare/wavefront/wavefront_map.h"

namespace glare {

namespace {

constexpr int kMostAnchors = 4000;

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
  const double intervals = std::max(3.0, std::ceil(all_rad / kPhasePerAnchor_rad));
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

/// Wavelengths at which the phase is frozen, and each one's window: over an interval between two of
/// them, the pattern is a cubic through the four nearest (all, of fewer), by Lagrange's
/// polynomials.
class Anchors {
 public:
  Anchors(std::vector<double> wavelengths_nm, const WavelengthRange& range)
      : nm_(std::move(wavelengths_nm)), range_(range) {}

  std::size_t size() const { return nm_.size(); }
  double wavelength_nm(std::size_t i) const { return nm_[i]; }

  /// Outside which the window is 0: two intervals to either side, three at the ends.
  WavelengthRange reach(std::size_t i) const {
    if (size() == 1) return range_;
    std::size_t first = i < 2 ? 0 : i - 2, last = std::min(i + 2, size() - 1);
    if (i == 3) first = 0;
    if (i + 4 == size()) last = size() - 1;
    return {nm_[first], nm_[last]};
  }

  double window(std::size_t i, double nm) const {
    const auto next =
        static_cast<std::size_t>(std::upper_bound(nm_.begin(), nm_.end(), nm) - nm_.begin());
    const std::size_t count = std::min<std::size_t>(kPoints, size());
    const std::size_t first = std::min(next < 2 ? 0 : next - 2, size() - count);
    if (i < first || i >= first + count) return 0;
    double product = 1;
    for (std::size_t k = first; k < first + count; ++k)
      if (k != i) product *= (nm - nm_[k]) / (nm_[i] - nm_[k]);
    return product;
  }

  /// Wavelengths between which the window is smooth and of one sign, and nearly linear: within
  /// 1/1000 of its height.
  std::vector<double> knots_nm(std::size_t i) const {
    constexpr int kParts = 16;
    const WavelengthRange ends = reach(i);
    std::vector<double> result = {ends.lo_nm};
    for (std::size_t k = 0; k + 1 < size(); ++k)
      for (int part = 1; part <= kParts; ++part) {
        const double nm = std::lerp(nm_[k], nm_[k + 1], static_cast<double>(part) / kParts);
        if (nm > ends.lo_nm && nm < ends.hi_nm) result.push_back(nm);
      }
    result.push_back(ends.hi_nm);
    return result;
  }

 private:
  static constexpr std::size_t kPoints = 4;
  std::vector<double> nm_;
  WavelengthRange range_;
};

/// The lamp's light times an anchor's window where that has the sign of `sign`, in absolute value.
Spectrum windowed(const Spectrum& lamp, const Anchors& anchors, std::size_t i, double sign) {
  std::vector<double> knots_nm = anchors.knots_nm(i);
  const WavelengthRange ends = anchors.reach(i);
  for (const double nm : lamp.wavelengths_nm())
    if (nm > ends.lo_nm && nm < ends.hi_nm) knots_nm.push_back(nm);
  std::sort(knots_nm.begin(), knots_nm.end());
  knots_nm.erase(std::unique(knots_nm.begin(), knots_nm.end()), knots_nm.end());
  std::vector<double> power;
  for (const double nm : knots_nm)
    power.push_back(lamp(nm) * std::max(0.0, sign * anchors.window(i, nm)));
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

  /// Adds the light of an anchor's window.
  void add_to(XyzImage& sum, const Anchors& anchors, std::size_t i, const Spectrum& lamp,
              double luminance, const ProgressCallback& progress) {
    constexpr double kDarkest = 1e-9;  // Of all the light: less is not seen.
    const WavelengthRange reach = anchors.reach(i);
    std::optional<FarFieldParts> field;
    for (const double sign : {1.0, -1.0}) {
      const Spectrum light = windowed(lamp, anchors, i, sign);
      const double share = luminous_integral(light, observer_, reach) / luminance;
      if (!(share > kDarkest)) continue;
      if (!field)
        field = field_at(anchors.wavelength_nm(i), reach, progress_part(progress, 0, 0.6));
      const double from = sign > 0 ? 0.6 : 0.8;
      integrate(field->even, light, reach, sign * share, progress_part(progress, from, from + 0.1),
                sum);
      integrate(field->odd, light, reach, sign * share,
                progress_part(progress, from + 0.1, from + 0.2), sum);
    }
  }

 private:
  FarFieldParts field_at(double wavelength_nm, const WavelengthRange& reach,
                         const ProgressCallback& progress) {
    part_.row = [&](int y, std::span<std::complex<float>> row) {
      map_.amplitude_row(y, wavelength_nm, row);
    };
    FarFieldRequest request =
        far_field_request(std::min(part_.width, part_.height) * part_.pixel_mm, grid_, reach);
    request.threads = threads_;
    request.progress = progress;
    return complex_far_field(part_, request);
  }

  void integrate(const FarField& field, const Spectrum& light, const WavelengthRange& reach,
                 double share, const ProgressCallback& progress, XyzImage& sum) {
    spectral_integral(field, grid_, light, observer_, reach, threads_, progress, picture_);
    add(picture_, share, sum);
  }

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
  const WavefrontMap map(pupil.aperture, pupil.aberrations, threads);
  require_fine_enough(map, pupil.aperture.pixel_mm(), range);
  const Anchors anchors(anchor_wavelengths_nm(map, range), range);
  const double luminance = luminous_integral(lamp, observer, range);
  XyzImage sum;
  sum.fill(Image<float>(grid.width, grid.height));
  AnchorIntegral integral(pupil, map, grid, observer, threads);
  const auto count = static_cast<double>(anchors.size());
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const auto done = static_cast<double>(i);
    integral.add_to(sum, anchors, i, lamp, luminance,
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
