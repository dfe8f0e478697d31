#include "headlamp/frame_maker.h"

#include <algorithm>
#include <cmath>

#include "aperture/eye_arguments.h"
#include "glare/io/atomic_file.h"
#include "glare/io/image_file.h"
#include "glare/io/picture_file.h"
#include "glare/io/sha256.h"
#include "glare/io/template_file.h"
#include "interruption.h"

namespace glare::tool {

namespace {

bool keep_going() { return !interrupted(); }

/// Whether there was a value to limit.
bool limit_to_half(Picture& picture) {
  bool limited = false;
  for (Image<float>& channel : picture.channels)
    for (float& value : channel.values()) {
      limited = limited || std::abs(value) > kLargestHalf;
      value = std::clamp(value, -kLargestHalf, kLargestHalf);
    }
  return limited;
}

}  // namespace

FrameMaker::FrameMaker(const SceneParts& parts) : parts_(parts) {
  const Backgrounds& backgrounds = parts.backgrounds;
  for (const SceneTemplate& t : parts.templates.all())
    kernels_.emplace_back(*t.glare_template, backgrounds.camera(), backgrounds.color_space());
}

double FrameMaker::illuminance_lux(const SceneLight& light, std::size_t lamp) const {
  if (parts_.scene.mode == SceneMode::physical) return light.at_eye.illuminance_lux;
  return illuminance_for_peak_lux(*parts_.templates.of_lamp(lamp).glare_template,
                                  light.relative_luminance);
}

void FrameMaker::make_picture(const SceneFrame& frame, Picture& result, int threads) const {
  const Camera& camera = parts_.backgrounds.camera();
  parts_.backgrounds.copy_picture(frame.index, result);
  std::vector<PointOfLight> points;
  for (std::size_t lamp = 0; lamp < parts_.scene.lamps.size(); ++lamp) {
    const SceneLight light = parts_.lights.light(lamp, camera, frame);
    const bool is_behind = light.at_eye.direction[2] <= 0;
    const double illuminance = is_behind ? 0 : illuminance_lux(light, lamp);
    if (illuminance > 0)
      points.push_back(
          {light.at_eye.direction, illuminance, kernels_[parts_.templates.index_of_lamp(lamp)]});
  }
  add_glare(result, camera, points, threads);
}

std::string FrameMaker::write(const SceneFrame& frame, const std::filesystem::path& file,
                              const HeadlampArguments& arguments, int threads) const {
  const auto linear = pictures_.take();
  make_picture(frame, *linear, threads);
  if (arguments.writes_exr()) {
    if (arguments.half && limit_to_half(*linear)) ++limited_frames_;
    const bool is_paper = parts_.scene.mode == SceneMode::paper;
    write_picture(
        file, *linear,
        {arguments.half,
         threads,
         {{"glare:unit", is_paper ? "relative" : "cd/m2"},
          {"glare:horizontalFov_deg", text_of(parts_.backgrounds.camera().horizontal_fov_deg)},
          {"glare:software", "glare " GLARE_VERSION}},
         keep_going});
    return sha256_of_file(file);
  }
  const auto display = parts_.display.encoded(*linear, threads);
  const std::vector<std::byte> png =
      arguments.bits == 16 ? encode_png_rgb16(display) : encode_png_rgb8(display);
  write_file_atomically(file, png, keep_going);
  return sha256_of(png);
}

}  // namespace glare::tool
