// What the module glare_color_config does, as the library sees it: C types, and nothing is thrown
// across. Internal.
#pragma once

#include "glare/io/module/message.h"

namespace glare::module {

enum class ConfigOutcome : int {
  found,
  no_such_space,    ///< The message lists the config's spaces most like it, perhaps none.
  not_usable,       ///< The space isn't scene-linear, or there is no such display or view.
  config_unusable,  ///< The config or a file it names can't be read, or lacks the roles.
  no_memory
};

/// The roles by which configs agree on a meaning: OpenColorIO's ACES2065-1, with white adapted to
/// D65, and CIE XYZ.
enum class InterchangeRole : int { aces, cie_xyz_d65 };

/// A scene-linear space of a config, by its way from the role that the config has.
struct ConfigSpace {
  InterchangeRole role;
  double space_from_role[3][3];  ///< `[row][column]`, applied to a column of the role's values.
};

/// A picture to be shown as a display and a view of the config would show it.
struct DisplayRequest {
  const char* config;
  const char* display;  ///< Empty: the config's default. So is the view, of that display.
  const char* view;
  double role_from_rgb[2][3]
                      [3];  ///< From the picture's colours to each role's, `[role][row][column]`.
  float* rgb;               ///< R, G, B of each pixel, row by row; changed in place.
  int width, height;
};

/// `message` says what is wrong, without the config's name in front, unless the space is found.
struct ColorConfigReader {
  const char* glare_version;  ///< First in every version, to be compared before anything is called.
  ConfigOutcome (*find_space)(const char* config, const char* name, ConfigSpace& space,
                              Message& message) noexcept;
  ConfigOutcome (*show)(const DisplayRequest& request, Message& message) noexcept;
};

}  // namespace glare::module

extern "C" __attribute__((visibility("default")))
const glare::module::ColorConfigReader glare_color_config;
