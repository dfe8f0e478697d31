// The recipe that a template's file carries: how to make it again.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "glare/io/lamp_file.h"
#include "template/template_arguments.h"

namespace glare::tool {

/// Writes the recipes of one command's templates.
class RecipeWriter {
 public:
  using Fingerprints = std::map<std::filesystem::path, std::string>;

  /// The arguments outlive this object. `known` are fingerprints of inputs that are no files, by
  /// the names that the arguments have for them.
  explicit RecipeWriter(const TemplateArguments& arguments, Fingerprints known = {})
      : arguments_(arguments), fingerprints_(std::move(known)) {}

  /// A JSON object {"command": [...], "inputs": [{"option", "file", "sha256"}, ...]}: the words of
  /// the command that makes this lamp's template alone, with every option that bears on the pixels,
  /// defaults included (output names and the number of threads don't), and a fingerprint of each
  /// file that was read. Throws `InputError` where one can't be read any more.
  std::string recipe(const NamedLamp& lamp);

 private:
  const std::string& fingerprint_of(const std::filesystem::path& file);

  const TemplateArguments& arguments_;
  Fingerprints fingerprints_;  ///< Each file is read once.
};

}  // namespace glare::tool
