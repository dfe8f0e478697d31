// Points of light of a text file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "glare/convolution/point_sources.h"

namespace glare::tool {

/// Rows of `x_px,y_px,red,green,blue`: the place, from the centre of the top left pixel of the data
/// window, right and down; the light as value times pixels, 0 or more, in the picture's channels.
/// Passed over: empty lines, comments (from # on), one line of words before the first row. At most
/// a million points. Throws `InputError` with `place` and line for anything else.
std::vector<PointSource> parse_sources(std::string_view text, const std::string& place);

/// The same from a file.
std::vector<PointSource> read_sources_file(const std::filesystem::path& path);

}  // namespace glare::tool
