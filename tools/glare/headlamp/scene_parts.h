// All that a scene's frames are made of.
#pragma once

#include "headlamp/backgrounds.h"
#include "headlamp/scene.h"
#include "headlamp/scene_display.h"
#include "headlamp/scene_frames.h"
#include "headlamp/scene_lights.h"
#include "headlamp/scene_templates.h"

namespace glare::tool {

/// Ready for any of the frames.
struct SceneParts {
  const Scene& scene;
  const Backgrounds& backgrounds;
  const SceneLights& lights;
  const SceneTemplates& templates;
  const SceneDisplay& display;
};

}  // namespace glare::tool
