#include "headlamp/scene_templates.h"

#include <algorithm>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/memory.h"
#include "glare/io/sha256.h"
#include "glare/io/template_file.h"
#include "template/template_notes.h"
#include "template/template_optics.h"
#include "template/template_recipe.h"

namespace glare::tool {

namespace {

/// What is wrong with a lamp's template, or with the options that make it, is told with its place
/// in the scene.
template <typename Function>
auto with_place(const std::string& place, const Function& function) {
  try {
    return function();
  } catch (const OptionError& error) {
    throw InputError(place, error.what());
  } catch (const InputError& error) {
    throw InputError(place, error.what());
  }
}

}  // namespace

SceneTemplates::SceneTemplates(const Scene& scene, const Console& console,
                               const std::string& cache_folder)
    : scene_(scene), console_(console), cache_folder_(cache_folder) {
  for (const SceneLamp& lamp : scene.lamps) {
    const bool from_file = !lamp.glare_template.empty();
    const std::string source = from_file ? lamp.glare_template.string() : lamp.spectrum;
    const auto same = std::find_if(
        templates_.begin(), templates_.end(),
        [&](const SceneTemplate& t) { return t.source == source && t.is_file == from_file; });
    of_lamp_.push_back(static_cast<std::size_t>(same - templates_.begin()));
    if (same != templates_.end()) continue;
    templates_.push_back({source, from_file, nullptr, {}});
    if (!from_file) {
      with_place(lamp.place, [&] { add_task(lamp); });
      continue;
    }
    const std::uint64_t limit = scene.template_arguments.memory_limit_bytes;
    templates_.back().glare_template = with_place(lamp.place, [&] {
      return std::make_shared<GlareTemplate>(
          read_template(lamp.glare_template, {limit ? limit : default_memory_limit_bytes()}));
    });
    templates_.back().sha256 = sha256_of_file(lamp.glare_template);
  }
}

void SceneTemplates::add_task(const SceneLamp& lamp) {
  Task task{templates_.size() - 1, lamp_from(lamp.spectrum), scene_.template_arguments, {}, {}};
  task.arguments.lamps = {lamp.spectrum};
  const TemplateOptions options = template_options(task.arguments);
  task.range = effective_range(task.lamp.spectrum, options);
  if (const auto warning = missed_light(task.lamp, options)) console_.warn(*warning);
  TemplateOptics(task.arguments, options, Console(Verbosity::quiet)).require_possible(task.range);
  task.recipe = RecipeWriter(task.arguments).recipe(task.lamp);
  tasks_.push_back(std::move(task));
}

void SceneTemplates::make() {
  if (tasks_.empty()) return;
  const TemplateCache cache(cache_folder_);
  const ProgressCallback progress = console_.progress("glare templates");
  TemplateOptions options = template_options(scene_.template_arguments);
  std::optional<TemplateOptics> optics;
  double done = 0;
  const auto count = static_cast<double>(tasks_.size());
  for (const Task& task : tasks_) {
    const auto part = [&](double from, double to) {
      return progress_part(progress, (done + from) / count, (done + to) / count);
    };
    auto stored = cache.find(task.recipe, options.memory_limit_bytes);
    if (!stored) {
      if (!optics) optics.emplace(scene_.template_arguments, options, console_);
      if (!optics->serves(task.range)) optics->make_far_field(task.range, part(0, 0.5));
      options.progress = part(0.5, 1);
      GlareTemplate made = made_template(*optics, task.lamp, options);
      made.recipe = task.recipe;
      stored = cache.store(made, options.threads);
      console_.tell("made the template of lamp " + task.lamp.name + ", kept in " +
                    cache.folder().string());
    }
    templates_[task.index].glare_template =
        std::make_shared<GlareTemplate>(std::move(stored->glare_template));
    templates_[task.index].sha256 = stored->sha256;
    ++done;
  }
}

}  // namespace glare::tool
