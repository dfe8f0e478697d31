// What a scene file says: who looks at which lamps, in front of what. docs/headlamps.md has every
// key.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glare/color/matrix.h"
#include "glare/photometry/luminous_intensity.h"
#include "glare/scatter/straylight.h"
#include "template/template_arguments.h"

namespace glare::tool {

inline constexpr int kMostSceneFrames = 100000;

/// Added luminance in cd/m^2 of measured intensities, or the 2010 paper's relative one.
enum class SceneMode { physical, paper };

/// The picture behind the lamps: a file, a sequence of them, or one luminance everywhere.
struct SceneBackground {
  std::filesystem::path file;  ///< Empty: plain; with {frame} in it: a sequence.
  int first_frame = 1;         ///< The number that {frame} begins at.
  std::optional<int> last_frame;
  std::optional<double> luminance_scale_cd_m2;  ///< Of a value of 1.
  double luminance_cd_m2 = 0;                   ///< Of a plain one.
  std::array<int, 2> size_px{1920, 1080};       ///< Of a plain one.
  double horizontal_fov_deg = 40;

  bool is_plain() const { return file.empty(); }
  bool is_sequence() const { return file.string().find("{frame}") != std::string::npos; }
};

/// Places and directions are (right, up, forward), in metres, in the axes of the picture; the
/// picture is taken from the eye.
struct SceneViewer {
  std::vector<Vector3> path_m{{0, 0, 0}};  ///< Of the eye, at an even speed; one place: it rests.
  int frames = 1;
  Vector3 line_of_sight{0, 0, 1};
  Straylight eye;  ///< The driver's, for CIE 146.
  /// For the threshold increment; not given: the background's mean.
  std::optional<double> adaptation_luminance_cd_m2;
};

/// What turns as one, with the lamps that it carries. Neutral, it drives against the viewer: its
/// forward is the viewer's (0, 0, -1), its right (-1, 0, 0).
struct SceneVehicle {
  std::string name;
  Vector3 position_m{};  ///< Of the point that it turns about.
  double yaw_deg = 0;    ///< To its own right.
};

struct SceneLamp {
  std::string name;
  std::string place;  ///< "FILE:LINE" of its table.
  std::optional<std::array<double, 2>> position_px;
  double distance_m = 0;               ///< From the eye, where the position is in pixels.
  std::optional<Vector3> position_m;   ///< In the axes of its vehicle, where it has one.
  std::optional<std::size_t> vehicle;  ///< Of the scene's vehicles.
  Mounting mounting;
  std::filesystem::path intensity;  ///< A photometric file or picture; empty: a constant.
  std::optional<std::array<double, 2>> horizontal_deg, vertical_deg;  ///< Ranges of a picture.
  std::optional<double> white_cd;                                     ///< Of a picture's 1.
  std::optional<int> lamp_set;                                        ///< Of EULUMDAT, from 1.
  double intensity_cd = 0;                                            ///< The constant.
  double flux_factor = 1;
  std::filesystem::path glare_template;      ///< A template's file; empty: made of `spectrum`.
  std::string spectrum = "D65";              ///< A lamp's name or its table's file.
  std::optional<double> relative_luminance;  ///< Of the paper's mode: L0.
};

/// The sigmoid or line, and a display's view, by the names of glare tonemap.
struct SceneToneMapping {
  std::string place;  ///< "FILE:LINE" of its table.
  std::optional<std::string> curve, transfer;
  std::optional<bool> per_channel;
  std::optional<double> adaptation_luminance, gamma, k, display_maximum;
  double exposure_stops = 0;
  std::filesystem::path config;  ///< Of OpenColorIO; empty: none.
  std::string display, view;     ///< Of the config; empty: its own choice.
};

struct Scene {
  std::filesystem::path file;
  SceneMode mode = SceneMode::physical;
  SceneBackground background;
  SceneViewer viewer;
  std::vector<SceneVehicle> vehicles;
  std::vector<SceneLamp> lamps;  ///< One or more.
  /// How templates are made, but for the lamp, the output and what belongs to a run.
  TemplateArguments template_arguments;
  SceneToneMapping tone_mapping;
  double reference_intensity_cd = 10;  ///< Of the paper's mode: where L0 is 1.
};

/// Reads a scene file. Throws `InputError`, whose place is "FILE:LINE", for a key that isn't known,
/// is missing, or has a value of another kind or outside its range.
Scene read_scene(const std::filesystem::path& file);

}  // namespace glare::tool
