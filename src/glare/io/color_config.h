// Colour spaces by name, built in or from a user's OpenColorIO config.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "glare/base/image.h"
#include "glare/color/color_space.h"
#include "glare/picture/picture.h"

namespace glare {

/// The names that need no config of the user's: "xyz", "lin_rec709" and so on
/// (data/color/make_config.py gives primaries, whites and standards).
std::vector<std::string> built_in_color_space_names();

/// The scene-linear colour space of this name.
///
/// A built-in name, spelled exactly so, means the built-in space, whatever the user's config holds;
/// its white isn't adapted. Any other name is looked up in `user_config` as OpenColorIO does: a
/// colour space, an alias or a role, in upper or lower case. The config's role `aces_interchange`,
/// or else `cie_xyz_d65_interchange`, ties its spaces to CIE XYZ, with the Bradford adaptation to
/// D65 that is part of what these roles mean. A space that is CIE XYZ to 1e-6 is taken for XYZ
/// itself, so that `is_xyz()` is true. The space returned has the name as given.
///
/// `user_config` is the path of an OpenColorIO config, of a .ocioz archive or an `ocio://` name
/// (both with OpenColorIO 2.2 and later), or empty for none. Files that the config names are found
/// by its own search path, and its variables are taken from the environment. OpenColorIO's messages
/// are silenced meanwhile, unless the environment variable OCIO_LOGGING_LEVEL asks for them.
///
/// Throws `OptionError` when no space has that name, and when it isn't scene-linear: by what the
/// config says of it, because values of 1e-6 to 1e4 of both signs aren't turned into its own by one
/// matrix, or because its white hasn't luminance 1. Throws `InputError`, with the config as the
/// place, when the config or a file it names can't be read, or it has neither of the two roles.
/// Throws `Error` when a config is needed and the module glare_color_config can't be loaded.
RgbColorSpace find_color_space(const std::string& name,
                               const std::filesystem::path& user_config = {});

/// The picture as a display of `user_config`, a config as above, shows it in one of its views: the
/// values for that display, in [0, 1] unless the view gives others. `display` and `view` are names,
/// in upper or lower case, or empty for the config's defaults. The picture's colours are brought to
/// the config's role by CIE XYZ, in the way that `find_color_space` has back.
///
/// Throws `OptionError` for a display or a view that there isn't, with those that there are;
/// `InputError` and `Error` as above.
Image<std::array<float, 3>> displayed(const Picture& picture,
                                      const std::filesystem::path& user_config,
                                      const std::string& display = {},
                                      const std::string& view = {});

/// The environment variable OCIO, by which programs agree on a config; empty when it isn't set.
std::filesystem::path color_config_from_environment();

}  // namespace glare
