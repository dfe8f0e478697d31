#include "headlamp/scene_notes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "glare/base/units.h"
#include "glare/scene/disability_glare.h"

namespace glare::tool {

namespace {

constexpr double kVisibleShare = 0.1;  // Of the background: a step that can't be missed.

/// The widest circle about the axis that a template has whole, in degrees.
double widest_angle_deg(const GlareTemplate& t) {
  const auto [x, y] = t.center_px();
  const int pixels = std::min({x, y, t.width() - 1 - x, t.height() - 1 - y});
  return std::asin(std::min(1.0, pixels * t.pixel_pitch_rad)) / kRadPerDeg;
}

double most_illuminance_lux(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                            std::size_t lamp) {
  double most = 0;
  for (const SceneFrame& frame : frames) {
    const SceneLight light = parts.lights.light(lamp, parts.backgrounds.camera(), frame);
    most = std::max(most, light.at_eye.illuminance_lux);
  }
  return most;
}

/// The largest intensity that a lamp has towards the eye in any frame.
double most_intensity_cd(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                         std::size_t lamp) {
  double most = 0;
  for (const SceneFrame& frame : frames) {
    const SceneLight light = parts.lights.light(lamp, parts.backgrounds.camera(), frame);
    most = std::max(most, light.at_eye.intensity_cd);
  }
  return most;
}

}  // namespace

void warn_of_dark_lamps(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                        const Console& console) {
  for (std::size_t i = 0; i < parts.scene.lamps.size(); ++i) {
    const SceneLamp& lamp = parts.scene.lamps[i];
    if (lamp.intensity.empty() || lamp.flux_factor == 0) continue;
    if (most_intensity_cd(parts, frames, i) > 0) continue;
    const bool points_down = parts.lights.is_type_c(i) && !lamp.mounting.gamma_zero_is_forward;
    console.warn("lamp '" + lamp.name + "' has no light towards the eye in any frame" +
                 (points_down ? ": it points down; of a headlamp or spotlight of type C, "
                                "gamma_zero is \"forward\""
                              : ""));
  }
}

void warn_of_borders(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                     const Console& console) {
  if (parts.scene.mode == SceneMode::paper) return;
  const Camera& camera = parts.backgrounds.camera();
  Picture background;
  parts.backgrounds.copy_picture(0, background);
  const double mean = average_luminance(background, camera);
  std::vector<const GlareTemplate*> told;
  for (std::size_t i = 0; i < parts.scene.lamps.size(); ++i) {
    const GlareTemplate& t = *parts.templates.of_lamp(i).glare_template;
    const double widest = widest_angle_deg(t);
    if (widest > camera.horizontal_fov_deg || std::count(told.begin(), told.end(), &t)) continue;
    const double veil = template_veil_per_lux(t, widest * 0.999).value_or(0) *
                        most_illuminance_lux(parts, frames, i);
    if (!(veil > kVisibleShare * mean)) continue;
    told.push_back(&t);
    char text[200];
    std::snprintf(text, sizeof text,
                  " ends %.3g degrees from it, with a veil of %.3g cd/m2 on a background of %.3g: "
                  "its border may show; a wider fov_deg in [template] helps",
                  widest, veil, mean);
    console.warn("the template of lamp '" + parts.scene.lamps[i].name + "'" + text);
  }
}

}  // namespace glare::tool
