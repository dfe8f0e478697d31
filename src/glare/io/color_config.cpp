// The one source file that includes OpenColorIO's headers.
#include "glare/io/color_config.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <sstream>
#include <string_view>

#include "glare/base/embedded_file.h"
#include "glare/base/error.h"

namespace glare {

extern const EmbeddedFile color_config_files[];
extern const std::size_t color_config_files_count;

namespace {

namespace OCIO = OCIO_NAMESPACE;

constexpr const char* kShippedConfig = "glare.ocio";
constexpr const char* kBuiltInCategory = "built_in";
constexpr const char* kXyz = "xyz";
constexpr const char* kInterchangeRoles[] = {"aces_interchange", "cie_xyz_d65_interchange"};
constexpr std::size_t kMostNamesListed = 10;

// While it lives, OpenColorIO logs nothing. The level is all that can be put back: a host program's
// logging function could be replaced, but not asked for.
class QuietOpenColorIO {
 public:
  QuietOpenColorIO() : lock_(mutex()), level_(OCIO::GetLoggingLevel()) {
    OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE);
  }
  ~QuietOpenColorIO() { OCIO::SetLoggingLevel(level_); }
  QuietOpenColorIO(const QuietOpenColorIO&) = delete;
  QuietOpenColorIO& operator=(const QuietOpenColorIO&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }

  std::lock_guard<std::mutex> lock_;
  OCIO::LoggingLevel level_;
};

std::string one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line, word;
  while (words >> word) line += (line.empty() ? "" : " ") + word;
  return line;
}

// What `work` returns; what OpenColorIO throws, or has no place yet, becomes an `InputError` at
// `place`.
template <typename Work>
auto with_errors_at(const std::string& place, const std::string& what_failed, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    if (!error.place().empty()) throw;
    throw InputError(place, what_failed + ": " + error.what());
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(place, what_failed + ": " + one_line(error.what()));
  }
}

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

// ---- Configs

OCIO::ConstConfigRcPtr read_shipped_config() {
  const EmbeddedFile* const end = color_config_files + color_config_files_count;
  const EmbeddedFile* const file =
      std::find_if(color_config_files, end,
                   [](const EmbeddedFile& candidate) { return candidate.name == kShippedConfig; });
  if (file == end) throw InputError(kShippedConfig, "it isn't compiled into the library");
  std::istringstream text{std::string(file->text)};
  return with_errors_at(kShippedConfig, "OpenColorIO can't read it",
                        [&] { return OCIO::Config::CreateFromStream(text); });
}

const OCIO::ConstConfigRcPtr& shipped_config() {
  static const OCIO::ConstConfigRcPtr config = read_shipped_config();
  return config;
}

OCIO::ConstConfigRcPtr read_user_config(const std::filesystem::path& path) {
  const std::string place = path.string();
  std::error_code ignored;
  if (!place.starts_with("ocio://") && std::filesystem::exists(path, ignored) &&
      !std::filesystem::is_regular_file(path, ignored))
    throw InputError(place, "an OpenColorIO config was expected, but this isn't a regular file");
  return with_errors_at(place, "it can't be read as an OpenColorIO config",
                        [&] { return OCIO::Config::CreateFromFile(place.c_str()); });
}

std::vector<OCIO::ConstColorSpaceRcPtr> scene_referred_spaces(const OCIO::Config& config) {
  const auto kind = OCIO::SEARCH_REFERENCE_SPACE_SCENE;
  const auto visibility = OCIO::COLORSPACE_ALL;
  std::vector<OCIO::ConstColorSpaceRcPtr> spaces;
  for (int i = 0; i < config.getNumColorSpaces(kind, visibility); ++i)
    spaces.push_back(config.getColorSpace(config.getColorSpaceNameByIndex(kind, visibility, i)));
  return spaces;
}

std::vector<std::string> read_built_in_names() {
  std::vector<std::string> names;
  for (const auto& space : scene_referred_spaces(*shipped_config()))
    if (space->hasCategory(kBuiltInCategory)) names.push_back(space->getName());
  return names;
}

bool is_built_in(const std::string& name) {
  const std::vector<std::string> names = read_built_in_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

// ---- Matrices

// In full precision, when the processor is made of matrices alone; float32 pixels would lose half
// of the digits.
std::optional<Matrix3> matrix_of_transform(const OCIO::ConstTransformRcPtr& transform) {
  const auto matrix_transform = OCIO_DYNAMIC_POINTER_CAST<const OCIO::MatrixTransform>(transform);
  if (!matrix_transform) return std::nullopt;
  double m44[16], offset[4];
  matrix_transform->getMatrix(m44);
  matrix_transform->getOffset(offset);
  if (offset[0] != 0 || offset[1] != 0 || offset[2] != 0) return std::nullopt;
  const Matrix3 matrix = {
      {{m44[0], m44[1], m44[2]}, {m44[4], m44[5], m44[6]}, {m44[8], m44[9], m44[10]}}};
  const bool forward = transform->getDirection() == OCIO::TRANSFORM_DIR_FORWARD;
  return forward ? matrix : inverse(matrix);
}

std::optional<Matrix3> product_of_matrices(const OCIO::Processor& processor) {
  const OCIO::ConstGroupTransformRcPtr steps = processor.createGroupTransform();
  Matrix3 product = identity_matrix();
  for (int i = 0; i < steps->getNumTransforms(); ++i) {
    const std::optional<Matrix3> step = matrix_of_transform(steps->getTransform(i));
    if (!step) return std::nullopt;
    product = *step * product;
  }
  return product;
}

Vector3 applied_to(const OCIO::CPUProcessor& processor, const Vector3& values) {
  float pixel[3];
  for (int k = 0; k < 3; ++k) pixel[k] = static_cast<float>(values[k]);
  processor.applyRGB(pixel);
  return {pixel[0], pixel[1], pixel[2]};
}

Matrix3 measured_matrix(const OCIO::CPUProcessor& processor) {
  Matrix3 matrix;
  for (int column = 0; column < 3; ++column) {
    Vector3 unit{};
    unit[column] = 1;
    const Vector3 image = applied_to(processor, unit);
    for (int row = 0; row < 3; ++row) matrix[row][column] = image[row];
  }
  return matrix;
}

bool agrees(const OCIO::CPUProcessor& processor, const Matrix3& matrix, const Vector3& values) {
  // Many times what a few steps in float32 may be off, and far less than an eye can see.
  constexpr double tolerance = 1e-4;
  const Vector3 actual = applied_to(processor, values);
  const Vector3 expected = matrix * values;
  for (int row = 0; row < 3; ++row) {
    double size = 0;
    for (int k = 0; k < 3; ++k) size += std::abs(matrix[row][k] * values[k]);
    if (!(std::abs(actual[row] - expected[row]) <= tolerance * size + 1e-20)) return false;
  }
  return true;
}

// True when the processor is this matrix over the range of an HDR picture: no curve, no limits, no
// offset.
bool is_linear(const OCIO::CPUProcessor& processor, const Matrix3& matrix) {
  constexpr Vector3 directions[] = {{1, 0, 0},     {0, 1, 0},     {0, 0, 1},      {1, 1, 1},
                                    {1, -0.5, 2},  {-0.3, 1, .1}, {0.2, .7, -1},  {1, 1e-3, 1e-6},
                                    {1e-6, 1, .1}, {.5, 3e-5, 1}, {0.9, 0.9, .01}};
  for (double size = 1e-6; size < 2e4; size *= 10)
    for (const Vector3& d : directions)
      for (const double signed_size : {size, -size})
        if (!agrees(processor, matrix,
                    {signed_size * d[0], signed_size * d[1], signed_size * d[2]}))
          return false;
  return true;
}

// The matrix to `to` from `from`; nothing when the way between them isn't a matrix.
std::optional<Matrix3> matrix_between(const OCIO::Config& config, const char* from,
                                      const char* to) {
  const OCIO::ConstProcessorRcPtr processor = config.getProcessor(from, to);
  const OCIO::ConstCPUProcessorRcPtr pixels =
      processor->getOptimizedCPUProcessor(OCIO::OPTIMIZATION_LOSSLESS);
  const std::optional<Matrix3> exact = product_of_matrices(*processor);
  const Matrix3 matrix = exact ? *exact : measured_matrix(*pixels);
  return is_linear(*pixels, matrix) ? std::optional(matrix) : std::nullopt;
}

// ---- What a user's config says of a space

struct Request {
  const std::string& name;
  const std::string& config_path;
  const OCIO::Config& config;
};

std::string quoted(const Request& request) {
  return "colour space '" + request.name + "' of " + request.config_path;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> previous(b.size() + 1), current(b.size() + 1);
  std::iota(previous.begin(), previous.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    current[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
      current[j + 1] =
          std::min({previous[j] + (a[i] == b[j] ? 0 : 1), previous[j + 1] + 1, current[j] + 1});
    std::swap(previous, current);
  }
  return previous.back();
}

// The config's own names that may be scene-linear, the most alike first.
std::vector<std::string> similar_names(const Request& request) {
  std::vector<std::string> names;
  for (const auto& space : scene_referred_spaces(request.config)) {
    const std::string encoding = in_lower_case(space->getEncoding());
    if (!space->isData() && (encoding.empty() || encoding == "scene-linear"))
      names.push_back(space->getName());
  }
  const std::string wanted = in_lower_case(request.name);
  const auto distance = [&](const std::string& name) {
    return edit_distance(wanted, in_lower_case(name));
  };
  std::stable_sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return distance(a) < distance(b);
  });
  names.resize(std::min(names.size(), kMostNamesListed));
  return names;
}

[[noreturn]] void throw_unknown_name(const std::string& name, const Request* request) {
  std::string message =
      "unknown colour space '" + name + "': built in are " + joined(read_built_in_names());
  if (!request) throw OptionError(message + "; no OpenColorIO config was given to look for it in");
  const std::vector<std::string> similar = similar_names(*request);
  message += "; " + request->config_path + " has no such space";
  if (!similar.empty()) message += ", but it has " + joined(similar);
  throw OptionError(message);
}

void check_declared_scene_linear(const Request& request, const OCIO::ColorSpace& space) {
  const std::string encoding = space.getEncoding();
  std::string reason;
  if (space.isData())
    reason = "it holds data, not colours";
  else if (space.getReferenceSpaceType() == OCIO::REFERENCE_SPACE_DISPLAY)
    reason = "it describes what a display emits";
  else if (!encoding.empty() && in_lower_case(encoding) != "scene-linear")
    reason = "its encoding is " + encoding;
  if (!reason.empty()) throw OptionError(quoted(request) + " isn't scene-linear: " + reason);
}

const char* interchange_role(const Request& request) {
  for (const char* role : kInterchangeRoles)
    if (request.config.hasRole(role)) return role;
  throw InputError(request.config_path,
                   "its spaces can't be tied to CIE XYZ, as it has neither a "
                   "role aces_interchange nor cie_xyz_d65_interchange");
}

// ---- Spaces

RgbColorSpace built_in_space(const std::string& name) {
  return with_errors_at(kShippedConfig, "OpenColorIO fails", [&]() -> RgbColorSpace {
    return {name, matrix_between(*shipped_config(), kXyz, name.c_str()).value()};
  });
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

void check_white(const Request& request, const RgbColorSpace& space) {
  // A matrix given with four decimals is off by less.
  constexpr double tolerance = 1e-3;
  const double luminance = space.white_xyz()[1];
  if (std::abs(luminance - 1) <= tolerance) return;
  std::ostringstream message;
  message << quoted(request) << " has a white of luminance " << luminance << ", and 1 was expected";
  throw OptionError(message.str());
}

RgbColorSpace user_space(const Request& request) {
  const OCIO::ConstColorSpaceRcPtr found = request.config.getColorSpace(request.name.c_str());
  if (!found) throw_unknown_name(request.name, &request);
  check_declared_scene_linear(request, *found);
  const char* const role = interchange_role(request);
  const auto space_from_role = matrix_between(request.config, role, request.name.c_str());
  const auto role_from_xyz = matrix_between(*shipped_config(), kXyz, role);
  if (!space_from_role || !role_from_xyz)
    throw OptionError(quoted(request) +
                      " isn't scene-linear: its values don't follow from those "
                      "of the role " +
                      role + " by a matrix");
  const RgbColorSpace space(request.name,
                            without_rounding_of_xyz(*space_from_role * *role_from_xyz));
  check_white(request, space);
  return space;
}

}  // namespace

std::vector<std::string> built_in_color_space_names() {
  const QuietOpenColorIO quiet;
  return read_built_in_names();
}

RgbColorSpace find_color_space(const std::string& name, const std::filesystem::path& user_config) {
  const QuietOpenColorIO quiet;
  if (is_built_in(name)) return built_in_space(name);
  if (user_config.empty()) throw_unknown_name(name, nullptr);
  const OCIO::ConstConfigRcPtr config = read_user_config(user_config);
  const std::string place = user_config.string();
  return with_errors_at(place, "its colour space '" + name + "' can't be used", [&] {
    return user_space({name, place, *config});
  });
}

std::filesystem::path color_config_from_environment() {
  const char* const path = std::getenv("OCIO");
  return path ? path : "";
}

}  // namespace glare
