// Scenes to add glare to, in cd/m^2 of linear BT.709.
//   make_scene night_street|sun_glint|christmas_tree SCENE.exr [WIDTH]
// Its field of view, of a perspective picture, is in the attribute glare:horizontalFov_deg.
#include <glare/glare.h>
#include <glare/glare_io.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "canvas.h"

namespace {

const std::map<std::string, scenes::Scene (*)()> kScenes{
    {"night_street", scenes::night_street},
    {"sun_glint", scenes::sun_glint},
    {"christmas_tree", scenes::christmas_tree}};

void run(scenes::Scene scene, const char* path, int width) {
  constexpr int kSamples = 4;  // across a pixel, and down it
  scene.camera.width = width;
  scene.camera.height = width * 9 / 16;
  glare::PictureFileOptions options;
  char fov[32];
  std::snprintf(fov, sizeof fov, "%g", scene.camera.fov_deg);
  options.attributes["glare:horizontalFov_deg"] = fov;
  glare::write_picture(path, scenes::drawn(scene, kSamples), options);
}

}  // namespace

int main(int argument_count, char** arguments) {
  const auto scene = argument_count > 1 ? kScenes.find(arguments[1]) : kScenes.end();
  const int width = argument_count == 4 ? std::atoi(arguments[3]) : 960;
  if (scene == kScenes.end() || argument_count < 3 || argument_count > 4 || width < 32 ||
      width > 8192) {
    std::fprintf(stderr,
                 "usage: make_scene night_street|sun_glint|christmas_tree SCENE.exr [WIDTH from 32 "
                 "to 8192]\n");
    return 2;
  }
  try {
    run(scene->second(), arguments[2], width);
  } catch (const glare::Error& error) {
    std::fprintf(stderr, "make_scene: %s\n", error.what());
    return 1;
  }
}
