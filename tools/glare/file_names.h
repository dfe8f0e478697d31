// Names of files.
#pragma once

#include <algorithm>
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

/// Whether two names lead to one file.
inline bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return canonical(a) == canonical(b) || std::filesystem::equivalent(a, b, error);
}

inline std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

/// What a name ends in, such as ".exr", in small letters.
inline std::string ending_of(const std::string& file) {
  return in_small_letters(std::filesystem::path(file).extension().string());
}

}  // namespace glare::tool
