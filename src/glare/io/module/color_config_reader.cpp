// The one source file that includes OpenColorIO's headers.
#include "glare/io/module/color_config_reader.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "glare/color/matrix.h"

namespace glare::module {

namespace {

namespace OCIO = OCIO_NAMESPACE;

constexpr std::size_t kMostNamesListed = 10;

const char* name_of(InterchangeRole role) {
  return role == InterchangeRole::aces ? "aces_interchange" : "cie_xyz_d65_interchange";
}

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

// What ends the work: its text is the message.
struct Refusal : std::runtime_error {
  Refusal(ConfigOutcome why, const std::string& message)
      : std::runtime_error(message), outcome(why) {}
  ConfigOutcome outcome;
};

// What `work` returns; what OpenColorIO throws becomes a refusal.
template <typename Work>
auto with_refusals(const std::string& what_failed, const Work& work) {
  try {
    return work();
  } catch (const Refusal&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Refusal(ConfigOutcome::config_unusable, what_failed + ": " + one_line(error.what()));
  }
}

// ---- Configs

OCIO::ConstConfigRcPtr read_config(const std::string& path) {
  return with_refusals("it can't be read as an OpenColorIO config",
                       [&] { return OCIO::Config::CreateFromFile(path.c_str()); });
}

std::vector<OCIO::ConstColorSpaceRcPtr> scene_referred_spaces(const OCIO::Config& config) {
  const auto kind = OCIO::SEARCH_REFERENCE_SPACE_SCENE;
  const auto visibility = OCIO::COLORSPACE_ALL;
  std::vector<OCIO::ConstColorSpaceRcPtr> spaces;
  for (int i = 0; i < config.getNumColorSpaces(kind, visibility); ++i)
    spaces.push_back(config.getColorSpace(config.getColorSpaceNameByIndex(kind, visibility, i)));
  return spaces;
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

Refusal not_scene_linear(const Request& request, const std::string& reason) {
  return {ConfigOutcome::not_usable, "colour space '" + request.name + "' of " +
                                         request.config_path + " isn't scene-linear: " + reason};
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

void check_declared_scene_linear(const Request& request, const OCIO::ColorSpace& space) {
  const std::string encoding = space.getEncoding();
  std::string reason;
  if (space.isData())
    reason = "it holds data, not colours";
  else if (space.getReferenceSpaceType() == OCIO::REFERENCE_SPACE_DISPLAY)
    reason = "it describes what a display emits";
  else if (!encoding.empty() && in_lower_case(encoding) != "scene-linear")
    reason = "its encoding is " + encoding;
  if (!reason.empty()) throw not_scene_linear(request, reason);
}

InterchangeRole interchange_role(const OCIO::Config& config) {
  for (const auto role : {InterchangeRole::aces, InterchangeRole::cie_xyz_d65})
    if (config.hasRole(name_of(role))) return role;
  throw Refusal(ConfigOutcome::config_unusable,
                "its spaces can't be tied to CIE XYZ, as it has neither a "
                "role aces_interchange nor cie_xyz_d65_interchange");
}

ConfigSpace config_space(const Request& request) {
  const OCIO::ConstColorSpaceRcPtr found = request.config.getColorSpace(request.name.c_str());
  if (!found) throw Refusal(ConfigOutcome::no_such_space, joined(similar_names(request)));
  check_declared_scene_linear(request, *found);
  const InterchangeRole role = interchange_role(request.config);
  const auto matrix = matrix_between(request.config, name_of(role), request.name.c_str());
  if (!matrix)
    throw not_scene_linear(request, "its values don't follow from those of the role " +
                                        std::string(name_of(role)) + " by a matrix");
  ConfigSpace space{role, {}};
  for (int row = 0; row < 3; ++row)
    std::copy((*matrix)[row].begin(), (*matrix)[row].end(), space.space_from_role[row]);
  return space;
}

ConfigSpace read_space(const std::string& config_path, const std::string& name) {
  const QuietOpenColorIO quiet;
  const OCIO::ConstConfigRcPtr config = read_config(config_path);
  return with_refusals("its colour space '" + name + "' can't be used", [&] {
    return config_space({name, config_path, *config});
  });
}

// ---- Displays and views

// The name as the config spells it. What there is otherwise is told.
std::string listed_name(const std::string& kind, const std::string& wanted,
                        const std::vector<std::string>& names, const std::string& owner) {
  for (const std::string& name : names)
    if (in_lower_case(name) == in_lower_case(wanted)) return name;
  throw Refusal(ConfigOutcome::not_usable, "unknown " + kind + " '" + wanted + "': " + owner +
                                               (names.empty() ? " has none" : " has ") +
                                               joined(names));
}

std::string display_of(const OCIO::Config& config, const DisplayRequest& request) {
  std::vector<std::string> names;
  for (int i = 0; i < config.getNumDisplays(); ++i) names.push_back(config.getDisplay(i));
  if (names.empty()) throw Refusal(ConfigOutcome::config_unusable, "it has no displays");
  if (*request.display == 0) return config.getDefaultDisplay();
  return listed_name("display", request.display, names, request.config);
}

std::string view_of(const OCIO::Config& config, const std::string& display,
                    const DisplayRequest& request) {
  std::vector<std::string> names;
  for (int i = 0; i < config.getNumViews(display.c_str()); ++i)
    names.push_back(config.getView(display.c_str(), i));
  if (*request.view == 0 && !names.empty()) return config.getDefaultView(display.c_str());
  return listed_name("view", request.view, names, "display '" + display + "' of " + request.config);
}

OCIO::MatrixTransformRcPtr matrix_transform(const double (&matrix)[3][3]) {
  double m44[16] = {};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) m44[4 * row + column] = matrix[row][column];
  m44[15] = 1;
  const auto transform = OCIO::MatrixTransform::Create();
  transform->setMatrix(m44);
  return transform;
}

OCIO::ConstCPUProcessorRcPtr display_processor(const OCIO::Config& config,
                                               const DisplayRequest& request) {
  const std::string display = display_of(config, request);
  const std::string view = view_of(config, display, request);
  const InterchangeRole role = interchange_role(config);
  const auto shown = OCIO::DisplayViewTransform::Create();
  shown->setSrc(name_of(role));
  shown->setDisplay(display.c_str());
  shown->setView(view.c_str());
  const auto all = OCIO::GroupTransform::Create();
  all->appendTransform(matrix_transform(request.role_from_rgb[static_cast<int>(role)]));
  all->appendTransform(shown);
  return with_refusals("its view '" + view + "' of display '" + display + "' can't be used",
                       [&] { return config.getProcessor(all)->getDefaultCPUProcessor(); });
}

void show_picture(const DisplayRequest& request) {
  const QuietOpenColorIO quiet;
  const OCIO::ConstConfigRcPtr config = read_config(request.config);
  const auto processor =
      with_refusals("it can't show a picture", [&] { return display_processor(*config, request); });
  OCIO::PackedImageDesc pixels(request.rgb, request.width, request.height, 3);
  processor->apply(pixels);
}

// ---- For the library

// What `work` comes to, with nothing thrown.
template <typename Work>
ConfigOutcome outcome_of(const Work& work, Message& message) noexcept try {
  work();
  return ConfigOutcome::found;
} catch (const Refusal& refusal) {
  message.set(refusal.what());
  return refusal.outcome;
} catch (const std::bad_alloc&) {
  return ConfigOutcome::no_memory;
} catch (...) {
  message.set("OpenColorIO fails");
  return ConfigOutcome::config_unusable;
}

ConfigOutcome find_space(const char* config, const char* name, ConfigSpace& space,
                         Message& message) noexcept {
  return outcome_of([&] { space = read_space(config, name); }, message);
}

ConfigOutcome show(const DisplayRequest& request, Message& message) noexcept {
  return outcome_of([&] { show_picture(request); }, message);
}

}  // namespace

}  // namespace glare::module

const glare::module::ColorConfigReader glare_color_config = {
    GLARE_VERSION, glare::module::find_space, glare::module::show};
