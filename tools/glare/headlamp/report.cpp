#include "headlamp/report.h"

#include <array>
#include <cmath>
#include <utility>

#include "glare/base/error.h"
#include "glare/scene/disability_glare.h"
#include "interruption.h"

namespace glare::tool {

namespace {

using Number = std::optional<double>;

Number product(double factor, const Number& number) {
  return number ? Number(factor * *number) : Number();
}

/// The veils at some angles from a lamp whose template's are `per_lux`.
std::vector<ReportedVeil> veils_of(double illuminance_lux, const std::vector<Number>& per_lux,
                                   const std::vector<double>& angles_deg, const Straylight& eye) {
  std::vector<ReportedVeil> veils;
  for (std::size_t i = 0; i < angles_deg.size(); ++i) {
    const std::array source{GlareSource{illuminance_lux, angles_deg[i]}};
    veils.push_back(
        {angles_deg[i], product(illuminance_lux, per_lux[i]), cie_veiling_luminance(source, eye)});
  }
  return veils;
}

Number increment(const Number& veil_cd_m2, const Number& adaptation_cd_m2) {
  if (!veil_cd_m2 || !adaptation_cd_m2) return std::nullopt;
  return threshold_increment_percent(*veil_cd_m2, *adaptation_cd_m2);
}

class Reporter {
 public:
  Reporter(const SceneParts& parts, const std::vector<double>& angles_deg)
      : parts_(parts), viewer_(parts.scene.viewer), angles_deg_(angles_deg) {
    for (const SceneTemplate& t : parts.templates.all()) {
      veils_per_lux_.emplace_back();
      for (const double angle : angles_deg)
        veils_per_lux_.back().push_back(template_veil_per_lux(*t.glare_template, angle));
    }
  }

  ReportedFrame frame(const SceneFrame& frame) {
    ReportedFrame reported{frame, {}, 0, {}, {}, adaptation_cd_m2(frame.index)};
    std::vector<GlareSource> sources;
    for (std::size_t i = 0; i < parts_.scene.lamps.size(); ++i) {
      reported.lamps.push_back(lamp(i, frame, reported.adaptation_luminance_cd_m2));
      sources.push_back(source_of(reported.lamps.back().light));
      reported.illuminance_lux += sources.back().illuminance_lux;
    }
    reported.veil_on_axis_cd_m2 = cie_veiling_luminance(sources, viewer_.eye);
    reported.threshold_increment_percent =
        increment(reported.veil_on_axis_cd_m2, reported.adaptation_luminance_cd_m2);
    return reported;
  }

 private:
  GlareSource source_of(const SceneLight& light) const {
    return {light.at_eye.illuminance_lux, light.off_axis_deg};
  }

  ReportedLamp lamp(std::size_t index, const SceneFrame& frame, const Number& adaptation) const {
    ReportedLamp reported{parts_.scene.lamps[index].name,
                          parts_.lights.light(index, parts_.backgrounds.camera(), frame),
                          {},
                          {},
                          {}};
    const std::array source{source_of(reported.light)};
    reported.veils =
        veils_of(source[0].illuminance_lux, veils_per_lux_[parts_.templates.index_of_lamp(index)],
                 angles_deg_, viewer_.eye);
    reported.veil_on_axis_cd_m2 = cie_veiling_luminance(source, viewer_.eye);
    reported.threshold_increment_percent = increment(reported.veil_on_axis_cd_m2, adaptation);
    return reported;
  }

  /// What the viewer tells, or the background's mean; of one background it is found once.
  Number adaptation_cd_m2(int frame) {
    if (viewer_.adaptation_luminance_cd_m2) return viewer_.adaptation_luminance_cd_m2;
    if (parts_.scene.mode == SceneMode::paper) return std::nullopt;  // It has no cd/m^2.
    if (mean_ && !parts_.scene.background.is_sequence()) return mean_;
    parts_.backgrounds.copy_picture(frame, picture_);
    mean_ = average_luminance(picture_, parts_.backgrounds.camera());
    if (!(std::isfinite(*mean_) && *mean_ >= 0)) mean_.reset();
    return mean_;
  }

  const SceneParts& parts_;
  const SceneViewer& viewer_;
  const std::vector<double>& angles_deg_;
  std::vector<std::vector<Number>> veils_per_lux_;  ///< Of each template, at each angle.
  Picture picture_;
  Number mean_;
};

}  // namespace

Report report_of(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                 const std::vector<double>& angles_deg) {
  Report report{parts.scene, {}};
  Reporter reporter(parts, angles_deg);
  for (const SceneFrame& frame : frames) {
    if (interrupted()) throw Cancelled();
    report.frames.push_back(reporter.frame(frame));
  }
  return report;
}

}  // namespace glare::tool
