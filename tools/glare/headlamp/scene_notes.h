// What there is to warn of in a scene.
#pragma once

#include <vector>

#include "console.h"
#include "headlamp/scene_parts.h"

namespace glare::tool {

/// Warns of lamps whose files have no light towards the eye in any frame.
void warn_of_dark_lamps(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                        const Console& console);

/// Warns where a template is so narrow that its border will show in the pictures: where it ends
/// within the picture, with a veil of more than a tenth of the background's mean.
void warn_of_borders(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                     const Console& console);

}  // namespace glare::tool
