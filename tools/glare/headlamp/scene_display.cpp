#include "headlamp/scene_display.h"

#include <cmath>
#include <filesystem>
#include <system_error>

#include "aperture/eye_arguments.h"
#include "glare/base/error.h"
#include "glare/io/color_config.h"
#include "glare/io/sha256.h"
#include "glare/scene/disability_glare.h"

namespace glare::tool {

namespace {

/// L_wa of the paper's figure 7, in its relative unit.
constexpr double kPaperAdaptation = 3e-4;

/// What the eye is adapted to: as the viewer tells, or the first background's mean.
double adaptation_cd_m2(const Scene& scene, const Backgrounds& backgrounds) {
  if (scene.viewer.adaptation_luminance_cd_m2) return *scene.viewer.adaptation_luminance_cd_m2;
  Picture picture;
  backgrounds.copy_picture(0, picture);
  const double mean = average_luminance(picture, backgrounds.camera());
  return mean > 0 && std::isfinite(mean) ? mean : 1;
}

ToneMapping mapping_of(const Scene& scene, const Backgrounds& backgrounds) {
  const SceneToneMapping& tone = scene.tone_mapping;
  const bool is_paper = scene.mode == SceneMode::paper;
  ToneMapping mapping;
  if (tone.curve.value_or("sigmoid") == "linear") mapping.curve = ToneMapping::Curve::linear;
  if (tone.per_channel.value_or(is_paper))
    mapping.application = ToneMapping::Application::per_channel;
  if (tone.transfer.value_or(is_paper ? "none" : "srgb") == "none")
    mapping.transfer = ToneMapping::Transfer::none;
  if (tone.adaptation_luminance)
    mapping.adaptation_luminance = *tone.adaptation_luminance;
  else
    mapping.adaptation_luminance =
        is_paper ? kPaperAdaptation : adaptation_cd_m2(scene, backgrounds);
  mapping.gamma = tone.gamma.value_or(mapping.gamma);
  mapping.k = tone.k.value_or(mapping.k);
  mapping.display_maximum = tone.display_maximum.value_or(mapping.display_maximum);
  mapping.exposure_stops = tone.exposure_stops;
  return mapping;
}

}  // namespace

SceneDisplay::SceneDisplay(const Scene& scene, const Backgrounds& backgrounds)
    : scene_(scene), mapping_(mapping_of(scene, backgrounds)) {
  if (!has_view()) return;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(scene.tone_mapping.config, ignored))
    config_sha256_ = sha256_of_file(scene.tone_mapping.config);
  Picture one;  // So that a config, display or view that isn't there is told before any work.
  one.channels.fill(Image<float>(1, 1));
  try {
    encoded(one, 1);
  } catch (const OptionError& error) {
    throw InputError(scene.tone_mapping.place, error.what());
  }
}

Image<std::array<float, 3>> SceneDisplay::encoded(Picture& picture, int threads) const {
  if (!has_view()) return tone_mapped(picture, mapping_, threads);
  const auto factor = static_cast<float>(std::exp2(mapping_.exposure_stops));
  for (Image<float>& channel : picture.channels)
    for (float& value : channel.values()) value *= factor;
  const SceneToneMapping& tone = scene_.tone_mapping;
  const std::scoped_lock lock(config_mutex_);  // Each call loads the config anew.
  return displayed(picture, tone.config, tone.display, tone.view);
}

std::string SceneDisplay::description() const {
  return text_of(mapping_.adaptation_luminance) + " " + scene_.tone_mapping.config.string() + " " +
         config_sha256_;
}

}  // namespace glare::tool
