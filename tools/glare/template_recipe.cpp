#include "template_recipe.h"

#include <nlohmann/json.hpp>

#include "glare/io/sha256.h"

namespace glare::tool {

std::string recipe(const std::vector<RecipeOption>& options) {
  nlohmann::ordered_json command = {"glare", "template"};
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  for (const RecipeOption& option : options) {
    command.push_back(option.name);
    for (const std::string& value : option.values) command.push_back(value);
    if (!option.file.empty())
      inputs.push_back({{"option", option.name},
                        {"file", option.file.filename().string()},
                        {"sha256", sha256_of_file(option.file)}});
  }
  const nlohmann::ordered_json whole = {{"command", command}, {"inputs", inputs}};
  return whole.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace glare::tool
