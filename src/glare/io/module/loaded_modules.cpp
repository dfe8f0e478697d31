// The modules of a shared build. Each is a file in the folder GLARE_MODULE_FOLDER beside the
// library that this code is in, wherever that lies: in a build tree, or installed, at any prefix.
#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "glare/base/error.h"
#include "glare/io/module/modules.h"

namespace glare::module {

namespace {

struct ModuleFile {
  const char* name;     ///< Of the file, without its ending, and of the symbol in it.
  const char* purpose;  ///< For people.
};

constexpr ModuleFile kImageCodec = {"glare_image_codec", "reading and writing pictures"};
constexpr ModuleFile kColorConfig = {"glare_color_config", "using an OpenColorIO config"};
constexpr ModuleFile kEyePhoto = {"glare_eye_photo", "finding an eye in a photograph"};

std::filesystem::path this_library() {
  static const char within = 0;
  Dl_info library{};
  std::error_code error;
  if (dladdr(&within, &library) == 0 || !library.dli_fname)
    throw Error("the folder of Glare's library can't be told");
  const auto path = std::filesystem::canonical(library.dli_fname, error);
  return error ? library.dli_fname : path;
}

[[noreturn]] void throw_unusable(const std::filesystem::path& path, const ModuleFile& file,
                                 const std::string& what) {
  throw Error(path.string() + ", needed for " + file.purpose + ", " + what);
}

/// What `file` gives. It stays loaded: the libraries it stands on aren't made to be unloaded.
template <typename Interface>
const Interface& loaded(const ModuleFile& file) {
  const auto path =
      this_library().parent_path() / GLARE_MODULE_FOLDER / (file.name + std::string(".so"));
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw_unusable(path, file, "isn't there");
  void* const module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) throw_unusable(path, file, std::string("can't be loaded: ") + dlerror());
  const auto* const found = static_cast<const Interface*>(dlsym(module, file.name));
  if (!found) throw_unusable(path, file, "isn't a module of Glare");
  const std::string version = found->glare_version;
  if (version != GLARE_VERSION)
    throw_unusable(path, file, "is of Glare " + version + "; " GLARE_VERSION " was expected");
  return *found;
}

}  // namespace

const ImageCodec& image_codec() {
  static const ImageCodec& codec = loaded<ImageCodec>(kImageCodec);
  return codec;
}

const ColorConfigReader& color_config_reader() {
  static const ColorConfigReader& reader = loaded<ColorConfigReader>(kColorConfig);
  return reader;
}

const EyePhotoReader& eye_photo_reader() {
  static const EyePhotoReader& reader = loaded<EyePhotoReader>(kEyePhoto);
  return reader;
}

}  // namespace glare::module
