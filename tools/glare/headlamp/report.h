// How strong the lamps' glare is, in numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "headlamp/scene_parts.h"

namespace glare::tool {

/// The veil at an angle from a lamp, in cd/m^2; nothing where it isn't known.
struct ReportedVeil {
  double angle_deg = 0;
  std::optional<double> from_template;  ///< Mean over the circle; where the template has it.
  std::optional<double> from_cie;       ///< CIE 146 for the driver; from 0.1 to 100 degrees.
};

struct ReportedLamp {
  std::string name;
  SceneLight light;
  std::vector<ReportedVeil> veils;
  std::optional<double> veil_on_axis_cd_m2;  ///< On the line of sight, after CIE 146.
  std::optional<double> threshold_increment_percent;
};

struct ReportedFrame {
  SceneFrame frame;
  std::vector<ReportedLamp> lamps;
  double illuminance_lux = 0;  ///< Of all lamps, as the next two.
  std::optional<double> veil_on_axis_cd_m2, threshold_increment_percent;
  std::optional<double> adaptation_luminance_cd_m2;
};

struct Report {
  const Scene& scene;
  std::vector<ReportedFrame> frames;
};

/// Of every frame and lamp, with the veils at these angles from each lamp. Throws `InputError`,
/// `Cancelled`.
Report report_of(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                 const std::vector<double>& angles_deg);

/// A line of column names, then a row for each frame and lamp; empty where a number isn't known.
std::string csv_of(const Report& report);

/// An object with "frames", each with "lamps"; null where a number isn't known.
std::string json_of(const Report& report);

}  // namespace glare::tool
