// Templates that were made once, kept in a folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "glare/template/glare_template.h"

namespace glare::tool {

/// A template as its file holds it.
struct StoredTemplate {
  GlareTemplate glare_template;
  std::string sha256;  ///< Of the file.
};

/// A folder of templates, each under the fingerprint of its recipe and of the program's version:
/// KEY.exr, and KEY.sha256 with the SHA-256 of that. What isn't whole, or is of another recipe, is
/// taken as if it weren't there.
class TemplateCache {
 public:
  /// An empty name is `glare/templates` in $XDG_CACHE_HOME or ~/.cache. Throws `OptionError` where
  /// neither is known.
  explicit TemplateCache(const std::string& folder);

  std::optional<StoredTemplate> find(const std::string& recipe,
                                     std::uint64_t memory_limit_bytes) const;
  /// Keeps a template and gives it back as its file holds it. Makes the folder where there is none.
  /// Throws `OutputError`, `Cancelled`.
  StoredTemplate store(const GlareTemplate& glare_template, int threads) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace glare::tool
