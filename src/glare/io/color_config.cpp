// The built-in spaces come from a table, so that only a user's config needs OpenColorIO, which is
// in the module glare_color_config.
#include "glare/io/color_config.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <sstream>
#include <system_error>

#include "glare/base/error.h"
#include "glare/io/built_in_color_spaces.h"
#include "glare/io/module/modules.h"

namespace glare {

namespace {

using module::ConfigOutcome;
using module::ConfigSpace;

void check_is_file(const std::filesystem::path& config) {
  const std::string place = config.string();
  std::error_code ignored;
  if (!place.starts_with("ocio://") && std::filesystem::exists(config, ignored) &&
      !std::filesystem::is_regular_file(config, ignored))
    throw InputError(place, "an OpenColorIO config was expected, but this isn't a regular file");
}

std::string unknown_name(const std::string& name) {
  std::string message = "unknown colour space '" + name + "': built in are ";
  std::string separator;
  for (const std::string& built_in : built_in_color_space_names()) {
    message += separator + built_in;
    separator = ", ";
  }
  return message;
}

[[noreturn]] void throw_refusal(ConfigOutcome outcome, const std::string& name,
                                const std::string& config, const std::string& message) {
  if (outcome == ConfigOutcome::no_memory) throw std::bad_alloc();
  if (outcome == ConfigOutcome::not_usable) throw OptionError(message);
  if (outcome == ConfigOutcome::no_such_space)
    throw OptionError(unknown_name(name) + "; " + config + " has no such space" +
                      (message.empty() ? "" : ", but it has " + message));
  throw InputError(config, message);
}

ConfigSpace read_space(const std::string& name, const std::string& config) {
  ConfigSpace space{};
  module::Message message;
  const auto outcome =
      module::color_config_reader().find_space(config.c_str(), name.c_str(), space, message);
  if (outcome != ConfigOutcome::found) throw_refusal(outcome, name, config, message.text);
  return space;
}

Matrix3 without_rounding_of_xyz(const Matrix3& rgb_from_xyz) {
  constexpr double tolerance = 1e-6;
  const Matrix3 identity = identity_matrix();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      if (!(std::abs(rgb_from_xyz[row][column] - identity[row][column]) <= tolerance))
        return rgb_from_xyz;
  return identity;
}

Matrix3 role_from_xyz(module::InterchangeRole role) {
  return role == module::InterchangeRole::aces ? aces_interchange_from_xyz() : identity_matrix();
}

Matrix3 space_from_xyz(const ConfigSpace& space) {
  Matrix3 space_from_role;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      space_from_role[row][column] = space.space_from_role[row][column];
  return without_rounding_of_xyz(space_from_role * role_from_xyz(space.role));
}

RgbColorSpace color_space_of(const std::string& name, const std::string& config,
                             const ConfigSpace& space) try {
  return {name, space_from_xyz(space)};
} catch (const InputError& error) {
  throw InputError(config, "its colour space '" + name + "' can't be used: " + error.message());
}

void check_white(const RgbColorSpace& space, const std::string& config) {
  // A matrix given with four decimals is off by less.
  constexpr double tolerance = 1e-3;
  const double luminance = space.white_xyz()[1];
  if (std::abs(luminance - 1) <= tolerance) return;
  std::ostringstream message;
  message << "colour space '" << space.name() << "' of " << config << " has a white of luminance "
          << luminance << ", and 1 was expected";
  throw OptionError(message.str());
}

Image<std::array<float, 3>> interleaved(const Picture& picture) {
  auto result = Image<std::array<float, 3>>::uninitialized(picture.width(), picture.height());
  for (std::size_t i = 0; i < result.values().size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) result.values()[i][k] = picture.channels[k].values()[i];
  return result;
}

module::DisplayRequest request_of(const Picture& picture, const std::string& config,
                                  const std::string& display, const std::string& view) {
  module::DisplayRequest request{};
  request.config = config.c_str();
  request.display = display.c_str();
  request.view = view.c_str();
  for (const auto role : {module::InterchangeRole::aces, module::InterchangeRole::cie_xyz_d65}) {
    const Matrix3 matrix = role_from_xyz(role) * picture.color_space.xyz_from_rgb();
    for (int row = 0; row < 3; ++row)
      std::copy(matrix[row].begin(), matrix[row].end(),
                request.role_from_rgb[static_cast<int>(role)][row]);
  }
  return request;
}

}  // namespace

std::vector<std::string> built_in_color_space_names() {
  std::vector<std::string> names;
  for (const RgbColorSpace& space : built_in_color_spaces()) names.push_back(space.name());
  return names;
}

RgbColorSpace find_color_space(const std::string& name, const std::filesystem::path& user_config) {
  for (const RgbColorSpace& space : built_in_color_spaces())
    if (space.name() == name) return space;
  if (user_config.empty())
    throw OptionError(unknown_name(name) + "; no OpenColorIO config was given to look for it in");
  check_is_file(user_config);
  const std::string config = user_config.string();
  const RgbColorSpace space = color_space_of(name, config, read_space(name, config));
  check_white(space, config);
  return space;
}

Image<std::array<float, 3>> displayed(const Picture& picture,
                                      const std::filesystem::path& user_config,
                                      const std::string& display, const std::string& view) {
  check_is_file(user_config);
  const std::string config = user_config.string();
  Image<std::array<float, 3>> result = interleaved(picture);
  if (result.empty()) return result;
  module::DisplayRequest request = request_of(picture, config, display, view);
  request.rgb = result.values().front().data();
  request.width = picture.width();
  request.height = picture.height();
  module::Message message;
  const auto outcome = module::color_config_reader().show(request, message);
  if (outcome != ConfigOutcome::found) throw_refusal(outcome, "", config, message.text);
  return result;
}

std::filesystem::path color_config_from_environment() {
  const char* const path = std::getenv("OCIO");
  return path ? path : "";
}

}  // namespace glare
