// The report as text.

#include <nlohmann/json.hpp>

#include "aperture/eye_arguments.h"
#include "headlamp/report.h"

namespace glare::tool {

namespace {

using Json = nlohmann::ordered_json;
using Number = std::optional<double>;

/// A number with its name.
struct Field {
  std::string name;
  Number value;
};

std::vector<Field> fields_of(const ReportedLamp& lamp) {
  const SceneLight& light = lamp.light;
  const LightAtEye& eye = light.at_eye;
  return {{"column_px", light.pixel ? Number((*light.pixel)[0]) : Number()},
          {"row_px", light.pixel ? Number((*light.pixel)[1]) : Number()},
          {"distance_m", eye.distance_m},
          {"horizontal_deg", eye.horizontal_deg},
          {"vertical_deg", eye.vertical_deg},
          {"intensity_cd", eye.intensity_cd},
          {"relative_luminance", light.relative_luminance},
          {"off_axis_deg", light.off_axis_deg},
          {"illuminance_lux", eye.illuminance_lux},
          {"veil_on_axis_cd_m2", lamp.veil_on_axis_cd_m2},
          {"threshold_increment_percent", lamp.threshold_increment_percent}};
}

std::vector<Field> fields_of(const ReportedFrame& frame) {
  return {{"illuminance_lux", frame.illuminance_lux},
          {"veil_on_axis_cd_m2", frame.veil_on_axis_cd_m2},
          {"adaptation_luminance_cd_m2", frame.adaptation_luminance_cd_m2},
          {"threshold_increment_percent", frame.threshold_increment_percent}};
}

/// A field of a CSV table: in quotation marks where it needs them.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string csv_number(const Number& number) { return number ? text_of(*number) : ""; }

/// The names and values of a row, beside the lamp's name.
std::vector<Field> csv_fields(const ReportedFrame& frame, const ReportedLamp& lamp) {
  std::vector<Field> fields = fields_of(lamp);
  for (const ReportedVeil& veil : lamp.veils)
    fields.push_back(
        {"veil_template_" + text_of(veil.angle_deg) + "deg_cd_m2", veil.from_template});
  for (const ReportedVeil& veil : lamp.veils)
    fields.push_back({"veil_cie_" + text_of(veil.angle_deg) + "deg_cd_m2", veil.from_cie});
  for (Field& field : fields_of(frame)) fields.push_back({"frame_" + field.name, field.value});
  return fields;
}

Json json_number(const Number& number) { return number ? Json(*number) : Json(nullptr); }

Json json_of(const std::vector<Field>& fields) {
  Json json = Json::object();
  for (const Field& field : fields) json[field.name] = json_number(field.value);
  return json;
}

Json json_of(const ReportedLamp& lamp) {
  Json json = {{"name", lamp.name}};
  json.update(json_of(fields_of(lamp)));
  json["veils"] = Json::array();
  for (const ReportedVeil& veil : lamp.veils)
    json["veils"].push_back({{"angle_deg", veil.angle_deg},
                             {"template_cd_m2", json_number(veil.from_template)},
                             {"cie_cd_m2", json_number(veil.from_cie)}});
  return json;
}

Json json_of(const ReportedFrame& frame) {
  Json json = {{"frame", frame.frame.index + 1},
               {"turn_deg", frame.frame.turn_deg},
               {"eye_m", frame.frame.eye_m}};
  json.update(json_of(fields_of(frame)));
  json["lamps"] = Json::array();
  for (const ReportedLamp& lamp : frame.lamps) json["lamps"].push_back(json_of(lamp));
  return json;
}

}  // namespace

std::string csv_of(const Report& report) {
  std::string text = "frame,turn_deg,lamp";
  for (const Field& field : csv_fields(report.frames.front(), report.frames.front().lamps.front()))
    text.append(",").append(field.name);
  text += "\n";
  for (const ReportedFrame& frame : report.frames)
    for (const ReportedLamp& lamp : frame.lamps) {
      text += std::to_string(frame.frame.index + 1);
      text.append(",").append(text_of(frame.frame.turn_deg));
      text.append(",").append(csv_text(lamp.name));
      for (const Field& field : csv_fields(frame, lamp))
        text.append(",").append(csv_number(field.value));
      text += "\n";
    }
  return text;
}

std::string json_of(const Report& report) {
  const SceneViewer& viewer = report.scene.viewer;
  Json json = {{"scene", report.scene.file.filename().string()},
               {"mode", report.scene.mode == SceneMode::paper ? "paper" : "physical"},
               {"age_years", viewer.eye.age_years},
               {"pigment", viewer.eye.pigment},
               {"reference_intensity_cd", report.scene.reference_intensity_cd},
               {"frames", Json::array()}};
  for (const ReportedFrame& frame : report.frames) json["frames"].push_back(json_of(frame));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace glare::tool
