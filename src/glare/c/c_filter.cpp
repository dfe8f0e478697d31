#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "glare/c/c_errors.h"
#include "glare/c/c_handles.h"
#include "glare/c/c_pixels.h"
#include "glare/c/c_structures.h"
#include "glare/convolution/glare_filter.h"
#include "glare/convolution/point_sources.h"

using namespace glare;
using namespace glare::c;

namespace {

constexpr std::int32_t kMostPixels = 65535;

glare_filter_options default_filter_options() {
  glare_filter_options o = {};
  o.struct_size = sizeof o;
  o.pixel_aspect = 1;
  return o;
}

glare_apply_options default_apply_options() {
  const ApplyGlareOptions defaults;
  glare_apply_options o = {};
  o.struct_size = sizeof o;
  o.exposure_stops = defaults.bright.exposure_stops;
  o.threshold = defaults.bright.threshold;
  o.knee = defaults.bright.knee;
  o.strength = defaults.strength;
  return o;
}

/// Options of the pictures, whose size is in range.
glare_filter_options filter_options(const glare_filter_options* given) {
  require(given, "filter options");
  const auto o = options_of(default_filter_options(), given, "filter options");
  if (o.width < 1 || o.height < 1 || o.width > kMostPixels || o.height > kMostPixels)
    throw OptionError("pictures of " + std::to_string(o.width) + " x " + std::to_string(o.height) +
                      " pixels: expected 1 to 65535 each way");
  return o;
}

PixelScale scale_of(const glare_filter_options& o) {
  if ((o.fov_deg != 0) == (o.pixel_deg != 0))
    throw OptionError("expected either fov_deg or pixel_deg");
  if (o.perspective != 0 && o.fov_deg == 0) throw OptionError("perspective takes fov_deg");
  PixelScale scale;
  if (o.fov_deg == 0)
    scale.pitch_rad = o.pixel_deg * std::numbers::pi / 180;
  else
    scale = o.perspective != 0 ? scale_of_perspective(o.fov_deg, o.width)
                               : scale_of_field_of_view(o.fov_deg, o.width);
  scale.pixel_aspect = o.pixel_aspect;
  return scale;
}

PixelKernelOptions kernel_options(const glare_filter_options& o) {
  using LampColor = PixelKernelOptions::LampColor;
  constexpr LampColor kLampColors[] = {LampColor::divided_out, LampColor::kept};
  PixelKernelOptions options;
  options.lamp_color = choice(kLampColors, o.lamp_color, "lamp_color");
  options.luminance_only = o.grey != 0;
  options.threads = threads_of(o.threads);
  return options;
}

ApplyGlareOptions apply_options(const glare_apply_options* given) {
  const auto o = options_of(default_apply_options(), given, "apply options");
  ApplyGlareOptions options;
  options.bright = {o.exposure_stops, o.threshold, o.knee};
  options.strength = o.strength;
  options.only_glare = o.only_glare != 0;
  options.threads = threads_of(o.threads);
  options.progress = progress_of(o.progress, o.user);
  return options;
}

/// The caller's picture, of the size and with the channels that are wanted.
Picture picture_of(const glare_pixels* pixels, int width, int height, bool grey,
                   const RgbColorSpace& color_space) {
  require(pixels, "pixels");
  require_valid(*pixels);
  if (pixels->width != width || pixels->height != height)
    throw OptionError("a picture of " + std::to_string(pixels->width) + " x " +
                      std::to_string(pixels->height) + " pixels for options of " +
                      std::to_string(width) + " x " + std::to_string(height));
  if (pixels->channels == 1 && !grey) throw OptionError("a grey picture takes the option grey");
  return {channels_from(*pixels), color_space};
}

/// Points in a picture's channels; where the picture is grey, of their luminance.
std::vector<PointSource> point_sources_of(const glare_point* points, std::size_t count, bool grey,
                                          const RgbColorSpace& color_space) {
  const auto& weights = color_space.xyz_from_rgb()[1];
  std::vector<PointSource> sources;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [r, g, b] = points[i].light;
    PointSource source{points[i].x_px, points[i].y_px, {r, g, b}};
    if (grey)
      source.light.fill(static_cast<float>(weights[0] * r + weights[1] * g + weights[2] * b));
    sources.push_back(source);
  }
  return sources;
}

}  // namespace

glare_status glare_filter_options_init(glare_filter_options* options, size_t size,
                                       glare_error* error) {
  return guarded(error,
                 [&] { init_options(default_filter_options(), options, size, "filter options"); });
}

glare_status glare_apply_options_init(glare_apply_options* options, size_t size,
                                      glare_error* error) {
  return guarded(error,
                 [&] { init_options(default_apply_options(), options, size, "apply options"); });
}

glare_status glare_filter_make(const glare_template* of, const glare_filter_options* options,
                               glare_filter** filter, glare_error* error) {
  return guarded(error, [&] {
    constexpr Edge kEdges[] = {Edge::black, Edge::extend};
    require_place(filter, "filter");
    require(of, "of");
    const glare_filter_options o = filter_options(options);
    const GlareFilterOptions how{choice(kEdges, o.edge, "edge"), threads_of(o.threads),
                                 limit_or_usual(o.memory_limit_bytes)};
    PixelKernelOptions kernel_of = kernel_options(o);
    if (how.edge == Edge::black) {  // Else light comes from all that lies beyond the border.
      kernel_of.reach_x_px = std::max(1, o.width - 1);
      kernel_of.reach_y_px = std::max(1, o.height - 1);
    }
    PixelKernel kernel = pixel_kernel(of->value, scale_of(o),
                                      color_space_of(o.color_space, o.ocio_config), kernel_of);
    *filter = new glare_filter{GlareFilter(std::move(kernel), o.width, o.height, how), o.grey != 0};
  });
}

void glare_filter_free(glare_filter* filter) { delete filter; }

glare_status glare_filter_shares(const glare_filter* filter, double captured[3], double kept[3],
                                 glare_error* error) {
  return guarded(error, [&] {
    require(filter, "filter");
    const PixelKernel& kernel = filter->filter.kernel();
    if (captured != nullptr) std::copy_n(kernel.captured.begin(), 3, captured);
    if (kept != nullptr) std::copy_n(kernel.kept.begin(), 3, kept);
  });
}

glare_status glare_filter_apply(const glare_filter* filter, const glare_apply_options* options,
                                const glare_pixels* pixels, glare_unusable_pixels* unusable,
                                glare_error* error) {
  return guarded(error, [&] {
    require(filter, "filter");
    const GlareFilter& prepared = filter->filter;
    const ApplyGlareOptions how = apply_options(options);
    Picture picture = picture_of(pixels, prepared.width(), prepared.height(), filter->grey,
                                 prepared.kernel().color_space);
    const UnusablePixels found = apply_glare(picture, prepared, how);
    copy_channels(picture.channels, *pixels);
    if (unusable != nullptr) *unusable = {found.nan, found.infinite, found.negative};
  });
}

glare_status glare_add_points(const glare_template* of, const glare_filter_options* options,
                              const glare_point* points, size_t count, double strength,
                              int32_t points_are_new, const glare_pixels* pixels,
                              glare_error* error) {
  return guarded(error, [&] {
    require(of, "of");
    if (count > 0) require(points, "points");
    const glare_filter_options o = filter_options(options);
    const RgbColorSpace color_space = color_space_of(o.color_space, o.ocio_config);
    const bool grey = o.grey != 0;
    PointGlareOptions how;
    how.kernel = kernel_options(o);
    how.strength = strength;
    how.points_are_new = points_are_new != 0;
    how.threads = threads_of(o.threads);
    Picture picture = picture_of(pixels, o.width, o.height, grey, color_space);
    add_point_glare(picture, point_sources_of(points, count, grey, color_space), of->value,
                    scale_of(o), how);
    copy_channels(picture.channels, *pixels);
  });
}
