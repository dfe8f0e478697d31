// The recipe that a template's file carries: how to make it again.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glare::tool {

/// An option of the command as it took effect, defaults included, and the file it names, if any.
struct RecipeOption {
  std::string name;  ///< "--lamp"
  std::vector<std::string> values;
  std::filesystem::path file;  ///< Empty where the option names no file.
};

/// A JSON object {"command": [...], "inputs": [{"option", "file", "sha256"}, ...]}: the command's
/// words with every option that bears on the pixels (output names and the number of threads don't),
/// and a fingerprint of each file that was read.
std::string recipe(const std::vector<RecipeOption>& options);

}  // namespace glare::tool
