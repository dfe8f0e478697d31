#include "headlamp/scene_frames.h"

#include <charconv>
#include <cmath>
#include <system_error>

#include "glare/base/error.h"
#include "glare/base/units.h"

namespace glare::tool {

namespace {

[[noreturn]] void refuse_turns(const std::string& text) {
  throw OptionError("--angles " + text +
                    ": expected LO:HI:STEP or A,B,C in degrees, each -360 to 360, and at most " +
                    std::to_string(kMostSceneFrames));
}

/// The numbers between separators.
std::vector<double> split_numbers(const std::string& text, char separator) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    double number = 0;
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || !(std::abs(number) <= 360)) refuse_turns(text);
    numbers.push_back(number);
    if (stop == end) return numbers;
    if (*stop != separator) refuse_turns(text);
    at = stop + 1;
  }
}

double distance(const Vector3& a, const Vector3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The place at a share (0 to 1) of a path's length.
Vector3 along(const std::vector<Vector3>& path, double share) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += distance(path[i - 1], path[i]);
  double left = share * length;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double part = distance(path[i - 1], path[i]);
    if (left <= part && part > 0) {
      Vector3 place = path[i - 1];
      for (std::size_t k = 0; k < 3; ++k) place[k] += left / part * (path[i][k] - place[k]);
      return place;
    }
    left -= part;
  }
  return path.back();
}

/// From a vehicle's axes, turned to its right, to the viewer's.
Vector3 seen_by_viewer(const Vector3& in_vehicle, double yaw_deg) {
  const double c = std::cos(yaw_deg * kRadPerDeg), s = std::sin(yaw_deg * kRadPerDeg);
  const auto& [right, up, forward] = in_vehicle;
  return {-(right * c + forward * s), up, -(forward * c - right * s)};
}

/// As many as the background's sequence has; nothing where that isn't told.
std::optional<int> background_frames(const SceneBackground& background) {
  if (!background.last_frame) return std::nullopt;
  return *background.last_frame - background.first_frame + 1;
}

}  // namespace

std::vector<double> turns_from(const std::string& text) {
  if (text.find(':') == std::string::npos) return split_numbers(text, ',');
  const std::vector<double> range = split_numbers(text, ':');
  if (range.size() != 3 || !(range[2] > 0) || range[1] < range[0]) refuse_turns(text);
  constexpr double kRounding = 1e-9;  // Of a step: decimal fractions aren't exact.
  const double steps = std::floor((range[1] - range[0]) / range[2] + kRounding);
  if (!(steps < kMostSceneFrames)) refuse_turns(text);
  std::vector<double> turns;
  for (int i = 0; i <= static_cast<int>(steps); ++i)
    turns.push_back(std::round((range[0] + i * range[2]) * 1e9) /
                    1e9);  // 0.3, not 0.30000000000000004.
  return turns;
}

std::vector<SceneFrame> frames_of(const Scene& scene, const std::vector<double>& turns_deg) {
  const bool moves = scene.viewer.path_m.size() > 1;
  const auto backgrounds = background_frames(scene.background);
  const int turns = static_cast<int>(turns_deg.size());
  const int count = turns > 0 ? turns : moves ? scene.viewer.frames : backgrounds.value_or(1);
  if (turns > 0 && moves && turns != scene.viewer.frames)
    throw OptionError("--angles has " + std::to_string(turns) + " angles, but the viewer's path " +
                      std::to_string(scene.viewer.frames) + " frames");
  if (backgrounds && count > *backgrounds)
    throw InputError(scene.file.string(), "there are " + std::to_string(count) +
                                              " frames, but only " + std::to_string(*backgrounds) +
                                              " backgrounds up to last_frame");
  if (count > kMostSceneFrames)
    throw InputError(scene.file.string(), "there are " + std::to_string(count) +
                                              " frames, expected at most " +
                                              std::to_string(kMostSceneFrames));
  std::vector<SceneFrame> frames;
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0;
    frames.push_back({i, turns > 0 ? turns_deg[static_cast<std::size_t>(i)] : 0,
                      along(scene.viewer.path_m, share)});
  }
  return frames;
}

LampPose pose_of(const Scene& scene, std::size_t index, const Camera& camera,
                 const SceneFrame& frame) {
  const SceneLamp& lamp = scene.lamps[index];
  LampPose pose{{}, lamp.mounting};
  pose.mounting.yaw_deg += frame.turn_deg;
  const auto move = [&](const Vector3& by, double factor) {
    for (std::size_t k = 0; k < 3; ++k) pose.position_m[k] += factor * by[k];
  };
  pose.position_m = {0, 0, 0};
  if (lamp.position_px) {  // As seen from where the path begins.
    move(camera.direction_of((*lamp.position_px)[0], (*lamp.position_px)[1]), lamp.distance_m);
    move(scene.viewer.path_m.front(), 1);
  } else if (lamp.vehicle) {
    const SceneVehicle& vehicle = scene.vehicles[*lamp.vehicle];
    pose.mounting.yaw_deg += vehicle.yaw_deg;
    move(seen_by_viewer(*lamp.position_m, vehicle.yaw_deg + frame.turn_deg), 1);
    move(vehicle.position_m, 1);
  } else {
    move(*lamp.position_m, 1);
  }
  move(frame.eye_m, -1);
  return pose;
}

}  // namespace glare::tool
