#include "glare/template/make_template.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <utility>

#include "glare/aperture/open_part.h"
#include "glare/base/error.h"
#include "glare/base/parallel.h"
#include "glare/base/units.h"
#include "glare/color/gamut.h"
#include "glare/integration/aberrated_integral.h"
#include "glare/scatter/straylight_pixels.h"
#include "glare/spectrum/observer.h"

namespace glare {

namespace {

/// A field may be this much wider than the reach, so that one written with three digits is taken;
/// only the very shortest wavelength, to which the eye is all but blind, is then a little short.
constexpr double kReachTolerance = 2e-3;

/// Rounded down to five digits, so that the number, given back as an option, is within the reach.
double rounded_down(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 4);
  return std::floor(value / unit) * unit;
}

void require_within_reach(double pixel_mm, double aperture_width_mm, const PixelGrid& grid,
                          double field_of_view_deg, double shortest_nm) {
  const double widest_deg = widest_field_of_view_deg(pixel_mm, shortest_nm, grid);
  if (field_of_view_deg <= widest_deg * (1 + kReachTolerance)) return;
  const double needed_mm = rounded_down(pixel_mm * widest_deg / field_of_view_deg);
  char text[320];
  std::snprintf(text, sizeof text,
                "a field of view of %g degrees is beyond the reach of the aperture: its pixels of "
                "%.4g um reach %.5g degrees; give at most --fov-deg %.5g, or an aperture with "
                "pixels of at most %.4g um (%.9g across its %g mm)",
                field_of_view_deg, pixel_mm * 1e3, rounded_down(widest_deg),
                rounded_down(widest_deg), needed_mm * 1e3, std::ceil(aperture_width_mm / needed_mm),
                aperture_width_mm);
  throw OptionError(text);
}

/// From the observer's XYZ to the template's RGB, adapted to the lamp where asked for.
Matrix3 rgb_from_observed_xyz(const TemplateOptions& options, const Xyz& lamp_xyz) {
  const Matrix3& rgb_from_xyz = options.color_space.rgb_from_xyz();
  if (options.white == WhiteAdaptation::none) return rgb_from_xyz;
  try {
    return rgb_from_xyz * bradford_adaptation(lamp_xyz, options.color_space.white_xyz());
  } catch (const InputError&) {
    throw OptionError("the lamp's colour is too saturated to be adapted to as white");
  }
}

template <typename T>
std::uint64_t bytes_of(int width, int height) {
  return static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * sizeof(T);
}

/// What OpenEXR takes to write rows of that width: twice as many blocks of 16 rows as there are
/// threads, each three times, and 256 rows in half precision.
std::uint64_t writing_bytes(int width, int threads) {
  const int used = threads_used(threads);
  constexpr int kChannels = 3, kHalfBytes = 2, kRowsInHalf = 256, kBlockRows = 16;
  return kChannels * (bytes_of<float>(width, 2 * 3 * kBlockRows * used) +
                      kHalfBytes * bytes_of<std::byte>(width, kRowsInHalf));
}

/// The part of an aperture's picture that lets light through.
ApertureSize open_size(const Aperture& aperture) {
  const OpenPart part = open_part(aperture);
  return {part.width, part.height, aperture.pixel_mm()};
}

FarFieldRequest far_field_request(const ApertureSize& open, const TemplateOptions& options,
                                  const WavelengthRange& range) {
  return far_field_request(std::min(open.width, open.height) * open.pixel_mm, pixel_grid(options),
                           range);
}

double sum_of(const Image<float>& image) {
  double sum = 0;
  for (const float value : image.values()) sum += value;
  return sum;
}

/// XYZ per steradian becomes RGB per steradian, in place.
void convert(std::array<Image<float>, 3>& channels, const Matrix3& rgb_from_xyz,
             const TemplateOptions& options) {
  const Vector3& weights = options.color_space.xyz_from_rgb()[1];
  const bool desaturate =
      options.gamut == GamutMapping::desaturate && !options.color_space.is_xyz();
  const auto x = channels[0].values(), y = channels[1].values(), z = channels[2].values();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vector3 v = rgb_from_xyz * Xyz{x[i], y[i], z[i]};
    std::array<float, 3> rgb = {static_cast<float>(v[0]), static_cast<float>(v[1]),
                                static_cast<float>(v[2])};
    if (desaturate) rgb = desaturated_into_gamut(rgb, weights);
    x[i] = rgb[0];
    y[i] = rgb[1];
    z[i] = rgb[2];
  }
}

/// What a luminance per steradian is divided by.
double normalizing_divisor(const GlareTemplate& glare_template) {
  if (glare_template.normalization == Normalization::absolute) return 1;
  double largest = 0, sum = 0;
  for (int y = 0; y < glare_template.height(); ++y)
    for (int x = 0; x < glare_template.width(); ++x) {
      const double luminance = glare_template.luminance(x, y);
      largest = std::max(largest, luminance);
      sum += luminance;
    }
  return glare_template.normalization == Normalization::peak ? largest : sum;
}

void normalize(GlareTemplate& glare_template) {
  const double divisor = normalizing_divisor(glare_template);
  if (!(divisor > 0)) throw InputError("template", "no light falls inside the field of view");
  for (auto& channel : glare_template.channels)
    for (float& value : channel.values()) value = static_cast<float>(value / divisor);
  glare_template.per_steradian = divisor;
}

void require_no_phase(const TemplateOptions& options) {
  if (options.aberrations.has_phase())
    throw OptionError(
        "aberrations that shift the phase need another far field for each wavelength: make the "
        "template from the aperture");
}

/// The aperture, or one with the Stiles-Crawford effect, if there is to be any, in `memory`.
const Aperture& as_weighed(const Aperture& aperture, const Aberrations& aberrations,
                           std::optional<Aperture>& memory) {
  if (!aberrations.stiles_crawford) return aperture;
  return memory.emplace(apodized(aperture, *aberrations.stiles_crawford, aberrations.pupil_center));
}

/// What a template tells of its aperture.
struct ApertureNumbers {
  double width_mm, area_mm2;
};

/// The share of the work that is done when straylight is added.
double share_before_straylight(const TemplateOptions& options) { return options.scatter ? 0.9 : 1; }

/// Adds the straylight, if there is to be any; the template has XYZ per steradian.
void scatter(GlareTemplate& result, const TemplateOptions& options) {
  result.scatter = options.scatter;
  if (!options.scatter) return;
  require_valid(*options.scatter);
  result.scattered_energy = add_straylight(
      *options.scatter, pixel_grid(options), result.lamp_xyz, options.threads,
      progress_part(options.progress, share_before_straylight(options), 1), result.channels);
}

/// A template without pixels, but with all that it tells of itself.
GlareTemplate labelled_template(const ApertureNumbers& aperture, const Spectrum& lamp,
                                const TemplateOptions& options, const std::string& lamp_name) {
  const auto& observer = color_matching_functions(options.observer);
  const WavelengthRange range = effective_range(lamp, options);
  GlareTemplate result;
  result.lamp_xyz = xyz_from_spectrum(lamp, observer, range);
  result.color_space = options.color_space;
  result.light_xyz =
      options.white == WhiteAdaptation::none ? result.lamp_xyz : options.color_space.white_xyz();
  result.pixel_pitch_rad = pixel_grid(options).pitch_rad;
  result.normalization = options.normalization;
  result.lamp = lamp_name;
  result.observer = observer.name;
  result.aberrations = to_string(options.aberrations);
  result.wavelength_range_nm = range;
  result.aperture_width_mm = aperture.width_mm;
  result.aperture_area_mm2 = aperture.area_mm2;
  result.software = "glare " GLARE_VERSION;
  return result;
}

/// From XYZ per steradian of the diffracted light to the template.
GlareTemplate finished_template(XyzImage xyz, const ApertureNumbers& aperture, const Spectrum& lamp,
                                const TemplateOptions& options, const std::string& lamp_name) {
  GlareTemplate result = labelled_template(aperture, lamp, options, lamp_name);
  result.channels = std::move(xyz);
  scatter(result, options);
  result.captured_energy =
      sum_of(result.channels[1]) * result.pixel_pitch_rad * result.pixel_pitch_rad;
  convert(result.channels, rgb_from_observed_xyz(options, result.lamp_xyz), options);
  normalize(result);
  return result;
}

}  // namespace

WavelengthRange effective_range(const Spectrum& lamp, const TemplateOptions& options) {
  const WavelengthRange& asked = options.wavelength_range_nm;
  if (asked.empty() || !(asked.lo_nm > 0) || !std::isfinite(asked.hi_nm))
    throw OptionError("the wavelength range is empty; expected two wavelengths, the shorter first");
  const auto& observer = color_matching_functions(options.observer);
  const WavelengthRange seen = intersection(asked, observer.range());
  if (seen.empty()) throw OptionError("the observer sees nothing in the wavelength range");
  const WavelengthRange range = intersection(seen, lamp.range());
  if (range.empty())
    throw InputError("lamp", "has no wavelength in common with the observer's range");
  xyz_from_spectrum(lamp, observer, range);  // Throws where the lamp is dark there.
  return range;
}

WavelengthRange effective_range(std::span<const Spectrum> lamps, const TemplateOptions& options) {
  if (lamps.empty()) throw InputError("lamps", "there are none");
  WavelengthRange range = effective_range(lamps.front(), options);
  for (const Spectrum& lamp : lamps.subspan(1)) {
    const WavelengthRange own = effective_range(lamp, options);
    range = {std::min(range.lo_nm, own.lo_nm), std::max(range.hi_nm, own.hi_nm)};
  }
  return range;
}

PixelGrid pixel_grid(const TemplateOptions& options) {
  constexpr int kLargest = 65535;
  if (options.width < 1 || options.height < 1 || options.width > kLargest ||
      options.height > kLargest)
    throw OptionError("a template has 1 to 65535 pixels a side");
  // Direction sines go from -1 to 1, which is 114.6 degrees as they are counted here.
  constexpr double kNarrowest_deg = 1e-6, kWidest_deg = 114;
  const double longer_side =
      static_cast<double>(std::max(options.width, options.height)) / options.width;
  if (!(options.field_of_view_deg >= kNarrowest_deg &&
        options.field_of_view_deg * longer_side <= kWidest_deg))
    throw OptionError("the field of view, across width and height, is from 1e-6 to 114 degrees");
  return {options.width, options.height, options.field_of_view_deg * kRadPerDeg / options.width};
}

double widest_field_of_view_deg(double pixel_mm, double shortest_nm, const PixelGrid& grid) {
  const double reach_rad = shortest_nm * kMmPerNm / pixel_mm;
  return reach_rad / kRadPerDeg * grid.width / std::max(grid.width, grid.height);
}

void require_far_field_possible(const Aperture& aperture, const TemplateOptions& options,
                                const WavelengthRange& range) {
  require_valid(aperture);
  if (options.scatter) require_valid(*options.scatter);
  require_valid(options.aberrations);
  require_within_reach(aperture.pixel_mm(), aperture.width_mm, pixel_grid(options),
                       options.field_of_view_deg, range.lo_nm);
  require_memory(open_size(aperture), options, range);
}

FarField template_far_field(const Aperture& aperture, const TemplateOptions& options,
                            const WavelengthRange& range) {
  require_no_phase(options);
  require_far_field_possible(aperture, options, range);
  FarFieldRequest request = far_field_request(open_size(aperture), options, range);
  request.threads = options.threads;
  request.progress = options.progress;
  std::optional<Aperture> memory;
  return far_field(as_weighed(aperture, options.aberrations, memory), request);
}

bool same_far_field(const FarField& field, const TemplateOptions& options,
                    const WavelengthRange& made_for, const WavelengthRange& range) {
  const PixelGrid grid = pixel_grid(options);
  const double open_side_mm = std::min(field.extent_x_mm, field.extent_y_mm);
  const FarFieldRequest a = far_field_request(open_side_mm, grid, made_for);
  const FarFieldRequest b = far_field_request(open_side_mm, grid, range);
  return a.max_frequency_x_per_mm == b.max_frequency_x_per_mm &&
         a.max_frequency_y_per_mm == b.max_frequency_y_per_mm &&
         a.overlap_frequency_x_per_mm == b.overlap_frequency_x_per_mm && a.padding == b.padding;
}

GlareTemplate make_template(const FarField& field, const Spectrum& lamp,
                            const TemplateOptions& options, const std::string& lamp_name) {
  require_no_phase(options);
  const WavelengthRange range = effective_range(lamp, options);
  return finished_template(
      spectral_integral(field, pixel_grid(options), lamp,
                        color_matching_functions(options.observer), range, options.threads,
                        progress_part(options.progress, 0, share_before_straylight(options))),
      {field.aperture_width_mm, field.energy_area_mm2}, lamp, options, lamp_name);
}

GlareTemplate make_template(const Aperture& aperture, const Spectrum& lamp,
                            const TemplateOptions& options, const std::string& lamp_name) {
  constexpr double kShareOfFarField = 0.2;
  const WavelengthRange range = effective_range(lamp, options);
  if (options.aberrations.has_phase()) {
    require_far_field_possible(aperture, options, range);
    std::optional<Aperture> memory;
    const Aperture& weighed = as_weighed(aperture, options.aberrations, memory);
    const AberratedPupil pupil{weighed, options.aberrations};
    return finished_template(
        aberrated_integral(pupil, pixel_grid(options), lamp,
                           color_matching_functions(options.observer), range, options.threads,
                           progress_part(options.progress, 0, share_before_straylight(options))),
        {weighed.width_mm, energy_area_mm2(weighed)}, lamp, options, lamp_name);
  }
  TemplateOptions part = options;
  part.progress = progress_part(options.progress, 0, kShareOfFarField);
  const FarField field = template_far_field(aperture, part, range);
  part.progress = progress_part(options.progress, kShareOfFarField, 1);
  return make_template(field, lamp, part, lamp_name);
}

GlareTemplate dark_template(double aperture_width_mm, const Spectrum& lamp,
                            const TemplateOptions& options, const std::string& lamp_name) {
  GlareTemplate result = labelled_template({aperture_width_mm, 0}, lamp, options, lamp_name);
  const PixelGrid grid = pixel_grid(options);
  result.channels.fill(Image<float>(grid.width, grid.height));
  result.per_steradian = 1;
  return result;
}

std::uint64_t template_bytes(const ApertureSize& aperture, const TemplateOptions& options,
                             const WavelengthRange& range) {
  const PixelGrid grid = pixel_grid(options);
  const FarFieldRequest request = far_field_request(aperture, options, range);
  const double open_side_mm = std::max(aperture.width, aperture.height) * aperture.pixel_mm;
  constexpr int kChannels = 3;
  const std::uint64_t sample_bytes = bytes_of<float>(aperture.width, aperture.height);
  const std::uint64_t weighed_bytes = options.aberrations.stiles_crawford ? sample_bytes : 0;
  if (options.aberrations.has_phase())
    return sample_bytes + weighed_bytes +
           aberrated_integral_bytes({aperture.width, aperture.height}, aperture.pixel_mm, grid,
                                    range, options.threads) +
           writing_bytes(grid.width, options.threads) + options.further_bytes;
  return sample_bytes + weighed_bytes +
         far_field_bytes(aperture.width, aperture.height, aperture.pixel_mm, request) +
         kChannels * bytes_of<float>(grid.width, grid.height) +
         std::max(spectral_integral_bytes(open_side_mm, grid, range, options.threads),
                  writing_bytes(grid.width, options.threads)) +
         options.further_bytes;
}

void require_memory(const ApertureSize& aperture, const TemplateOptions& options,
                    const WavelengthRange& range) {
  const std::uint64_t needed_bytes = template_bytes(aperture, options, range);
  if (options.memory_limit_bytes != 0 && needed_bytes > options.memory_limit_bytes)
    throw MemoryError(needed_bytes, options.memory_limit_bytes);
}

}  // namespace glare
