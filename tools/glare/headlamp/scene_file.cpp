#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/color_config.h"
#include "glare/spectrum/lamps.h"
#include "headlamp/scene.h"
#include "headlamp/scene_eye.h"
#include "headlamp/toml_table.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;

constexpr NumberRange kMetres{-1e6, 1e6};
constexpr NumberRange kDistance{1e-3, 1e6};
constexpr NumberRange kTurn{-360, 360};
constexpr NumberRange kSomeLight{1e-12, 1e12};
constexpr NumberRange kLight{0, 1e12};
constexpr NumberRange kFrames{0, 1e6};

Vector3 vector_of(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

std::optional<std::array<double, 2>> pair_of(const TomlTable& table, const std::string& key,
                                             NumberRange range) {
  const auto numbers = table.numbers(key, 2, range);
  if (!numbers) return std::nullopt;
  return std::array{numbers->at(0), numbers->at(1)};
}

[[noreturn]] void refuse(const TomlTable& table, const std::string& key,
                         const std::string& message) {
  throw InputError(table.place_of(key), message);
}

/// Refuses the second key where both are there.
void require_one_of(const TomlTable& table, const std::string& first, const std::string& second) {
  if (table.has(first) && table.has(second))
    refuse(table, second, second + " and " + first + " exclude one another");
}

void require_with(const TomlTable& table, const std::string& key, const std::string& other) {
  if (table.has(key) && !table.has(other)) refuse(table, key, key + " goes with " + other);
}

SceneBackground background_of(const TomlTable& table) {
  SceneBackground background;
  background.horizontal_fov_deg =
      table.number("horizontal_fov_deg", {0.001, 179}).value_or(background.horizontal_fov_deg);
  for (const char* key : {"luminance_cd_m2", "size_px"}) require_one_of(table, "file", key);
  for (const char* key : {"luminance_scale_cd_m2", "first_frame"}) require_with(table, key, "file");
  if (const auto file = table.file("file")) background.file = *file;
  background.luminance_scale_cd_m2 = table.number("luminance_scale_cd_m2", kSomeLight);
  background.first_frame = table.whole_number("first_frame", kFrames).value_or(1);
  background.last_frame = table.whole_number("last_frame", kFrames);
  for (const char* key : {"first_frame", "last_frame"})
    if (table.has(key) && !background.is_sequence())
      refuse(table, key, std::string(key) + " goes with a file whose name has {frame} in it");
  if (background.last_frame && *background.last_frame < background.first_frame)
    refuse(table, "last_frame", "last_frame is before first_frame");
  background.luminance_cd_m2 = table.number("luminance_cd_m2", kLight).value_or(0);
  background.size_px = table.size("size_px", {1, 65535}).value_or(background.size_px);
  table.require_all_keys_known();
  return background;
}

SceneViewer viewer_of(const TomlTable& table) {
  SceneViewer viewer;
  if (table.has("path_m")) viewer.path_m.clear();
  for (const auto& point : table.points("path_m", kMetres))
    viewer.path_m.push_back(vector_of(point));
  viewer.frames = table.whole_number("frames", {2, kMostSceneFrames}).value_or(1);
  if (table.has("frames") && viewer.path_m.size() < 2)
    refuse(table, "frames", "frames goes with path_m of two points or more");
  if (viewer.path_m.size() > 1 && viewer.frames < 2)
    refuse(table, "path_m", "path_m of several points goes with frames, 2 or more");
  if (const auto axis = table.numbers("line_of_sight", 3, kMetres)) {
    viewer.line_of_sight = vector_of(*axis);
    if (viewer.line_of_sight == Vector3{}) refuse(table, "line_of_sight", "line_of_sight is 0");
  }
  viewer.eye.age_years =
      table.number("age_years", {0, kOldestStraylight_years}).value_or(viewer.eye.age_years);
  viewer.eye.pigment = table.number("pigment", {0, kPalestStraylight}).value_or(viewer.eye.pigment);
  viewer.adaptation_luminance_cd_m2 = table.number("adaptation_luminance_cd_m2", kSomeLight);
  table.require_all_keys_known();
  return viewer;
}

SceneVehicle vehicle_of(const TomlTable& table, const std::vector<SceneVehicle>& others) {
  SceneVehicle vehicle;
  const auto name = table.text("name");
  if (!name) throw InputError(table.place(), "[[vehicles]]: name is missing");
  vehicle.name = *name;
  for (const SceneVehicle& other : others)
    if (other.name == vehicle.name)
      refuse(table, "name", "another vehicle is named '" + other.name + "'");
  const auto position = table.numbers("position_m", 3, kMetres);
  if (!position) throw InputError(table.place(), "[[vehicles]]: position_m is missing");
  vehicle.position_m = vector_of(*position);
  vehicle.yaw_deg = table.number("yaw_deg", kTurn).value_or(0);
  table.require_all_keys_known();
  return vehicle;
}

void read_position(const TomlTable& table, const std::vector<SceneVehicle>& vehicles,
                   SceneLamp& lamp) {
  require_one_of(table, "position_m", "position_px");
  require_with(table, "distance_m", "position_px");
  require_with(table, "vehicle", "position_m");
  lamp.position_px = pair_of(table, "position_px", {-1e6, 1e6});
  if (lamp.position_px && !table.has("distance_m"))
    refuse(table, "position_px", "position_px goes with distance_m");
  lamp.distance_m = table.number("distance_m", kDistance).value_or(0);
  if (const auto position = table.numbers("position_m", 3, kMetres))
    lamp.position_m = vector_of(*position);
  if (!lamp.position_m && !lamp.position_px)
    throw InputError(table.place(),
                     "[[lamps]]: expected position_m, or position_px and distance_m");
  const auto vehicle = table.text("vehicle");
  if (!vehicle) return;
  const auto found = std::find_if(vehicles.begin(), vehicles.end(),
                                  [&](const SceneVehicle& v) { return v.name == *vehicle; });
  if (found == vehicles.end()) refuse(table, "vehicle", "there is no vehicle '" + *vehicle + "'");
  lamp.vehicle = static_cast<std::size_t>(found - vehicles.begin());
}

void read_intensity(const TomlTable& table, SceneLamp& lamp) {
  require_one_of(table, "intensity", "intensity_cd");
  for (const char* key : {"h_deg", "v_deg", "white_cd", "lamp_set", "gamma_zero"})
    require_with(table, key, "intensity");
  require_with(table, "h_deg", "v_deg");
  require_with(table, "v_deg", "h_deg");
  if (const auto file = table.file("intensity")) lamp.intensity = *file;
  lamp.horizontal_deg = pair_of(table, "h_deg", kTurn);
  lamp.vertical_deg = pair_of(table, "v_deg", kTurn);
  lamp.white_cd = table.number("white_cd", kSomeLight);
  lamp.lamp_set = table.whole_number("lamp_set", {1, 1000});
  lamp.intensity_cd = table.number("intensity_cd", kLight).value_or(0);
  if (!table.has("intensity") && !table.has("intensity_cd"))
    throw InputError(table.place(), "[[lamps]]: expected intensity, a file, or intensity_cd");
  lamp.flux_factor = table.number("flux_factor", {0, 1e6}).value_or(1);
  lamp.relative_luminance = table.number("relative_luminance", kLight);
  lamp.mounting.yaw_deg = table.number("yaw_deg", kTurn).value_or(0);
  lamp.mounting.pitch_deg = table.number("pitch_deg", kTurn).value_or(0);
  lamp.mounting.roll_deg = table.number("roll_deg", kTurn).value_or(0);
  lamp.mounting.gamma_zero_is_forward =
      table.word("gamma_zero", {"down", "forward"}).value_or("down") == "forward";
}

/// A lamp's name, or the file that it is relative to the scene's.
std::string spectrum_of(const TomlTable& table) {
  const std::string spectrum = *table.text("spectrum");
  try {
    return find_lamp(spectrum) ? spectrum : table.file("spectrum")->string();
  } catch (const OptionError& error) {
    refuse(table, "spectrum", error.what());
  }
}

SceneLamp lamp_of(const TomlTable& table, std::size_t number,
                  const std::vector<SceneVehicle>& vehicles) {
  SceneLamp lamp;
  lamp.place = table.place();
  lamp.name = table.text("name").value_or("lamp" + std::to_string(number));
  read_position(table, vehicles, lamp);
  read_intensity(table, lamp);
  require_one_of(table, "template", "spectrum");
  if (const auto file = table.file("template")) lamp.glare_template = *file;
  if (table.has("spectrum")) lamp.spectrum = spectrum_of(table);
  table.require_all_keys_known();
  return lamp;
}

/// A config's display and view, instead of a curve.
void read_view(const TomlTable& table, SceneToneMapping& tone) {
  if (const auto config = table.text("ocio"))
    tone.config = config->starts_with("ocio://") ? fs::path(*config) : *table.file("ocio");
  tone.display = table.text("display").value_or("");
  tone.view = table.text("view").value_or("");
  const std::string given = table.has("ocio") ? "ocio" : table.has("view") ? "view" : "display";
  if (!table.has(given)) return;
  if (tone.config.empty()) tone.config = color_config_from_environment();
  if (tone.config.empty())
    refuse(table, given, given + " needs an OpenColorIO config: ocio or $OCIO");
  for (const char* key : {"curve", "per_channel", "transfer", "adaptation_luminance", "gamma", "k",
                          "display_maximum"})
    require_one_of(table, given, key);
}

SceneToneMapping tone_mapping_of(const TomlTable& table) {
  SceneToneMapping tone;
  tone.place = table.place();
  tone.curve = table.word("curve", {"sigmoid", "linear"});
  tone.per_channel = table.truth("per_channel");
  tone.transfer = table.word("transfer", {"srgb", "none"});
  tone.adaptation_luminance = table.number("adaptation_luminance", kSomeLight);
  tone.gamma = table.number("gamma", {0.1, 10});
  tone.k = table.number("k", {1, 1e4});
  tone.display_maximum = table.number("display_maximum", {1e-6, 1e4});
  tone.exposure_stops = table.number("exposure_stops", {-100, 100}).value_or(0);
  read_view(table, tone);
  table.require_all_keys_known();
  return tone;
}

void read_lamps(const TomlTable& whole, Scene& scene) {
  for (const TomlTable& table : whole.tables("vehicles"))
    scene.vehicles.push_back(vehicle_of(table, scene.vehicles));
  for (const TomlTable& table : whole.tables("lamps")) {
    scene.lamps.push_back(lamp_of(table, scene.lamps.size() + 1, scene.vehicles));
    for (std::size_t i = 0; i + 1 < scene.lamps.size(); ++i)
      if (scene.lamps[i].name == scene.lamps.back().name)
        throw InputError(table.place_of("name"),
                         "another lamp is named '" + scene.lamps[i].name + "'");
  }
  if (scene.lamps.empty())
    throw InputError(scene.file.string(), "the scene has no lamp: expected a table [[lamps]]");
}

}  // namespace

Scene read_scene(const std::filesystem::path& file) {
  const TomlTable whole = TomlTable::read(file);
  Scene scene;
  scene.file = file;
  scene.mode = whole.word("mode", {"physical", "paper"}).value_or("physical") == "paper"
                   ? SceneMode::paper
                   : SceneMode::physical;
  scene.background = background_of(whole.table("background"));
  scene.viewer = viewer_of(whole.table("viewer"));
  scene.template_arguments.age_years = scene.viewer.eye.age_years;
  scene.template_arguments.pigment = scene.viewer.eye.pigment;
  read_eye_table(whole.table("eye"), scene.template_arguments);
  read_template_table(whole.table("template"), scene.template_arguments);
  read_lamps(whole, scene);
  scene.tone_mapping = tone_mapping_of(whole.table("tone_mapping"));
  const TomlTable paper = whole.table("paper");
  scene.reference_intensity_cd =
      paper.number("reference_intensity_cd", kSomeLight).value_or(scene.reference_intensity_cd);
  paper.require_all_keys_known();
  whole.require_all_keys_known();
  return scene;
}

}  // namespace glare::tool
