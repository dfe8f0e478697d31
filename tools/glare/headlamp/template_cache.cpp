#include "headlamp/template_cache.h"

#include <span>
#include <string_view>
#include <system_error>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/sha256.h"
#include "glare/io/template_file.h"
#include "glare/io/transform_cache.h"
#include "interruption.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::string key_of(const std::string& recipe) {
  return sha256_of(bytes_of("glare " GLARE_VERSION "\n" + recipe));
}

std::string content_of(const fs::path& file) {
  constexpr std::uint64_t kMostBytes = 1000;
  const std::vector<std::byte> bytes = read_file(file, kMostBytes);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw OutputError(folder.string(), "can't make the folder of templates, " + error.message() +
                                           "; --template-cache names another one");
}

}  // namespace

TemplateCache::TemplateCache(const std::string& folder) : folder_(folder) {
  if (!folder.empty()) return;
  const fs::path plans = transform_plans_path();
  if (plans.empty())
    throw OptionError(
        "neither XDG_CACHE_HOME nor HOME tells where to keep templates: expected --template-cache");
  folder_ = plans.parent_path() / "templates";
}

std::optional<StoredTemplate> TemplateCache::find(const std::string& recipe,
                                                  std::uint64_t memory_limit_bytes) const {
  const fs::path file = folder_ / (key_of(recipe) + ".exr");
  try {
    const std::string sha256 = content_of(fs::path(file).replace_extension(".sha256"));
    if (sha256_of_file(file) != sha256) return std::nullopt;
    StoredTemplate stored{read_template(file, {memory_limit_bytes}), sha256};
    if (stored.glare_template.recipe != recipe) return std::nullopt;
    return stored;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

StoredTemplate TemplateCache::store(const GlareTemplate& glare_template, int threads) const {
  make_folder(folder_);
  const fs::path file = folder_ / (key_of(glare_template.recipe) + ".exr");
  const auto keep_going = [] { return !interrupted(); };
  write_template(file, glare_template, {false, threads, keep_going});
  const std::string sha256 = sha256_of_file(file);
  write_file_atomically(fs::path(file).replace_extension(".sha256"), bytes_of(sha256), keep_going);
  return {read_template(file), sha256};
}

}  // namespace glare::tool
