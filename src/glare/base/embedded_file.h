// A data file that is compiled into the library (see cmake/GlareEmbed.cmake).
#pragma once

#include <cstddef>
#include <string_view>

namespace glare {

struct EmbeddedFile {
  std::string_view name;  ///< File name without a folder, such as "cie_a.csv".
  std::string_view text;
};

}  // namespace glare
