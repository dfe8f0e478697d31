// One name for each file.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace glare::tool {

/// The same path for every way to reach a file, whether it is there or not.
inline std::filesystem::path canonical(const std::string& file) {
  std::error_code error;
  const std::filesystem::path path =
      std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
  return error ? std::filesystem::path(file) : path;
}

}  // namespace glare::tool
