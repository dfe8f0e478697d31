// The templates of a scene's lamps.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "console.h"
#include "glare/io/lamp_file.h"
#include "glare/template/make_template.h"
#include "headlamp/scene.h"
#include "headlamp/template_cache.h"
#include "template/template_arguments.h"

namespace glare::tool {

/// A template that one lamp or several have.
struct SceneTemplate {
  std::string source;  ///< Its file, or the spectrum that it is made of.
  bool is_file;
  std::shared_ptr<const GlareTemplate> glare_template;
  std::string sha256;  ///< Of its file.
};

/// Reads or makes each of the scene's templates once.
class SceneTemplates {
 public:
  /// Reads the templates' files, and reads and checks what the others are made of; makes nothing.
  /// Throws `InputError`, `OptionError`, `MemoryError`. The arguments outlive this object.
  SceneTemplates(const Scene& scene, const Console& console, const std::string& cache_folder);

  /// Finds or makes those that are made of a spectrum. Throws `OutputError`, `Cancelled`.
  void make();

  /// After `make`. The template of each lamp, in the scene's order.
  const SceneTemplate& of_lamp(std::size_t lamp) const { return templates_[of_lamp_[lamp]]; }
  const std::vector<SceneTemplate>& all() const { return templates_; }
  std::size_t index_of_lamp(std::size_t lamp) const { return of_lamp_[lamp]; }

 private:
  /// One to be found or made.
  struct Task {
    std::size_t index;  ///< Of templates_.
    NamedLamp lamp;
    TemplateArguments arguments;
    WavelengthRange range;
    std::string recipe;
  };
  void add_task(const SceneLamp& lamp);

  const Scene& scene_;
  const Console& console_;
  std::string cache_folder_;
  std::vector<SceneTemplate> templates_;
  std::vector<std::size_t> of_lamp_;
  std::vector<Task> tasks_;
};

}  // namespace glare::tool
