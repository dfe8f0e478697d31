#include "apply/picture_glare.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "apply/sources_file.h"
#include "glare/base/error.h"
#include "glare/convolution/roll_off.h"
#include "glare/io/color_config.h"
#include "glare/io/sha256.h"
#include "glare/io/template_file.h"

namespace glare::tool {

namespace {

std::optional<RgbColorSpace> told_color_space(const ApplyArguments& a) {
  if (a.color_space.empty()) return std::nullopt;
  return find_color_space(a.color_space, a.ocio.empty() ? color_config_from_environment()
                                                        : std::filesystem::path(a.ocio));
}

std::string key_of(const ApplyArguments& a, const GlareInputs& inputs) {
  nlohmann::ordered_json all = {{"software", "glare " GLARE_VERSION},
                                {"options", description_of(a)},
                                {"template", sha256_of_file(a.glare_template)}};
  if (a.has_sources_file()) all["sources"] = sha256_of_file(a.sources);
  if (inputs.color_space) all["color_space"] = inputs.color_space->rgb_from_xyz();
  const std::string text = all.dump();
  return sha256_of(std::as_bytes(std::span(text.data(), text.size())));
}

bool is_finite(const Picture& picture, std::size_t i, float factor) {
  return std::ranges::all_of(picture.channels, [&](const Image<float>& channel) {
    return std::isfinite(factor * channel.values()[i]);
  });
}

/// The exposed picture plus `added`; pixels that aren't finite get nothing.
void add(Picture& picture, const Picture& added, float exposure) {
  for (std::size_t i = 0; i < picture.channels[0].values().size(); ++i) {
    const bool gets_light = is_finite(picture, i, exposure);
    for (std::size_t k = 0; k < 3; ++k) {
      float& value = picture.channels[k].values()[i];
      value = exposure * value + (gets_light ? added.channels[k].values()[i] : 0.0f);
    }
  }
}

/// A fade that ends at the nearest border of the template, on this scale.
RollOff roll_off_of(const GlareTemplate& t, const PixelScale& scale, double share) {
  const double across = t.pixel_pitch_rad / scale.pitch_rad, down = across * scale.pixel_aspect;
  // Of an even number of pixels there is one more to the left of the axis, and above it.
  const auto radius = [](int size, double ratio) {
    return static_cast<int>(std::clamp(((size - 1) / 2 + 0.5) * ratio, 1.0, 1e6));
  };
  return {radius(t.width(), across), radius(t.height(), down), share};
}

/// That the whole kernel fits into the memory: on fine pixels it may be of any size.
void require_fitting(const GlareTemplate& t, const GlareWork& work) {
  const double across = t.pixel_pitch_rad / work.scale.pitch_rad,
               down = across * work.scale.pixel_aspect;
  const double bytes = 3.0 * sizeof(float) * (across * t.width() + 2) * (down * t.height() + 2);
  if (bytes > static_cast<double>(work.memory_bytes))
    throw MemoryError(static_cast<std::uint64_t>(std::min(bytes, 0x1p63)), work.memory_bytes);
}

/// Each point's light as grey of its luminance.
void make_gray(std::vector<PointSource>& points, const RgbColorSpace& color_space) {
  const auto& weights = color_space.xyz_from_rgb()[1];
  for (PointSource& point : points) {
    double luminance = 0;
    for (std::size_t k = 0; k < 3; ++k) luminance += weights[k] * point.light[k];
    point.light.fill(static_cast<float>(luminance));
  }
}

}  // namespace

GlareInputs read_glare_inputs(const ApplyArguments& a) {
  GlareInputs inputs;
  inputs.glare_template = read_template(a.glare_template, {a.memory_bytes()});
  if (a.has_sources_file()) inputs.points = read_sources_file(a.sources);
  inputs.color_space = told_color_space(a);
  inputs.key = key_of(a, inputs);
  return inputs;
}

PixelKernelOptions PictureGlare::kernel_options(const Picture& picture, bool is_gray) const {
  PixelKernelOptions options;
  options.lamp_color = arguments_.lamp_color_kind();
  options.luminance_only = is_gray;
  // From beyond a border that goes on, light comes from farther away too; and what a fade takes is
  // known of a whole kernel alone.
  if (arguments_.edge_kind() == Edge::extend || arguments_.roll_off > 0) return options;
  options.reach_x_px = std::max(1, picture.width() - 1);
  options.reach_y_px = std::max(1, picture.height() - 1);
  return options;
}

PixelKernel PictureGlare::kernel_for(const Picture& picture, const GlareWork& work) const {
  const PixelKernelOptions options = kernel_options(picture, work.is_gray);
  if (options.reach_x_px == 0) require_fitting(inputs_.glare_template, work);
  PixelKernel kernel =
      pixel_kernel(inputs_.glare_template, work.scale, picture.color_space, options);
  if (arguments_.roll_off > 0)
    roll_off(kernel, roll_off_of(inputs_.glare_template, work.scale, arguments_.roll_off));
  return kernel;
}

GlareFilter PictureGlare::filter_for(const Picture& picture, const GlareWork& work) const {
  const Kind kind{picture.width(),         picture.height(), work.scale.pitch_rad,
                  work.scale.pixel_aspect, work.is_gray,     picture.color_space.rgb_from_xyz(),
                  work.memory_bytes};
  const std::scoped_lock lock(mutex_);  // Others wait for what they need too.
  if (filter_ && filter_->kind == kind) return filter_->filter;
  filter_.reset();
  GlareFilterOptions options;
  options.edge = arguments_.edge_kind();
  options.threads = arguments_.threads;
  options.memory_limit_bytes = work.memory_bytes;
  GlareFilter filter(kernel_for(picture, work), picture.width(), picture.height(), options);
  filter_.emplace(Filter{kind, filter});
  return filter;
}

void PictureGlare::add_points(Picture& picture, std::vector<PointSource> points,
                              const GlareWork& work) const {
  Picture added;
  added.color_space = picture.color_space;
  added.channels.fill(Image<float>(picture.width(), picture.height()));
  if (work.is_gray) make_gray(points, picture.color_space);
  PointGlareOptions options;
  options.kernel = kernel_options(picture, work.is_gray);
  // Points beside the picture reach farther into it than its own pixels do.
  if (arguments_.has_sources_file()) options.kernel.reach_x_px = options.kernel.reach_y_px = 0;
  options.strength = arguments_.strength;
  options.points_are_new = arguments_.new_sources;
  options.threads = work.threads;
  options.progress = work.progress;
  add_point_glare(added, points, inputs_.glare_template, work.scale, options);
  if (arguments_.only_glare)
    picture.channels = std::move(added.channels);
  else
    add(picture, added, static_cast<float>(std::exp2(arguments_.bright.exposure_stops)));
}

std::optional<GlareOutcome> PictureGlare::apply_by_points(Picture& picture,
                                                          const GlareWork& work) const {
  GlareOutcome outcome;
  if (arguments_.has_sources_file()) {
    std::vector<PointSource> points = inputs_.points;
    const float exposure = static_cast<float>(std::exp2(arguments_.bright.exposure_stops));
    for (PointSource& point : points)
      for (float& light : point.light) light *= exposure;
    outcome.points = points.size();
    add_points(picture, std::move(points), work);
    return outcome;
  }
  if (arguments_.sources != "auto") return std::nullopt;
  Picture light;
  outcome.unusable = bright_part(picture, arguments_.bright, light, work.threads);
  auto points = few_points(light, arguments_.edge_kind());
  if (!points) return std::nullopt;
  outcome.points = points->size();
  add_points(picture, std::move(*points), work);
  return outcome;
}

GlareOutcome PictureGlare::apply(Picture& picture, const GlareWork& work) const {
  if (inputs_.color_space) picture.color_space = *inputs_.color_space;
  if (const auto outcome = apply_by_points(picture, work)) return *outcome;
  const GlareFilter filter = filter_for(picture, work);
  ApplyGlareOptions options;
  options.bright = arguments_.bright;
  options.strength = arguments_.strength;
  options.only_glare = arguments_.only_glare;
  options.threads = work.threads;
  options.progress = work.progress;
  return {apply_glare(picture, filter, options), {}};
}

}  // namespace glare::tool
