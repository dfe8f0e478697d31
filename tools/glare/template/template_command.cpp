// glare template: from an aperture and lamps to a glare template in a file for each lamp.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "console.h"
#include "glare/glare.h"
#include "glare/glare_io.h"
#include "interruption.h"
#include "template/template_arguments.h"
#include "template/template_notes.h"
#include "template/template_optics.h"
#include "template/template_outputs.h"
#include "template/template_recipe.h"

namespace glare::tool {

namespace {

/// A template to be made.
struct Task {
  NamedLamp lamp;
  TemplateOutput output;
  WavelengthRange range;  ///< Integrated over.
  std::string recipe;
};

/// The wavelengths integrated over; an error names the lamp as it was given.
WavelengthRange range_of(const NamedLamp& lamp, const TemplateOptions& options) {
  try {
    return effective_range(lamp.spectrum, options);
  } catch (const InputError& error) {
    throw InputError(lamp.file.empty() ? "lamp " + lamp.name : lamp.file.string(), error.message());
  }
}

/// The lamps' tables, with a warning for each that misses much of the light.
std::vector<NamedLamp> read_lamps(const TemplateArguments& arguments) {
  const Console console(arguments.verbosity());
  const TemplateOptions options = template_options(arguments);
  std::vector<NamedLamp> lamps;
  for (const std::string& lamp : arguments.lamps) lamps.push_back(lamp_from(lamp));
  for (const NamedLamp& lamp : lamps) {
    range_of(lamp, options);  // Tells first what is wrong with a lamp.
    if (const auto warning = missed_light(lamp, options)) console.warn(*warning);
  }
  return lamps;
}

/// The lamps with their outputs; whatever is wrong with one of them is told before any work.
std::vector<Task> tasks_of(const TemplateArguments& arguments, const std::vector<NamedLamp>& lamps,
                           const TemplateOptions& options) {
  const std::vector<TemplateOutput> outputs = template_outputs(arguments);
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < outputs.size(); ++i)
    tasks.push_back({lamps[i], outputs[i], range_of(lamps[i], options), {}});
  return tasks;
}

/// Puts lamps that can share a far field side by side, the widest range first.
void sort_by_range(std::vector<Task>& tasks) {
  std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) {
    return std::pair(a.range.lo_nm, -a.range.hi_nm) < std::pair(b.range.lo_nm, -b.range.hi_nm);
  });
}

/// Hands out the progress bar in equal steps: one for each lamp, and one for each far field.
class Steps {
 public:
  Steps(const std::vector<Task>& tasks, ProgressCallback whole)
      : count_(static_cast<double>(tasks.size())), whole_(std::move(whole)) {
    for (std::size_t i = 0; i < tasks.size(); ++i)
      if (i == 0 || !(tasks[i].range == tasks[i - 1].range)) ++count_;
  }
  ProgressCallback next() {
    const double from = done_++ / count_;
    return progress_part(whole_, from, done_ / count_);
  }

 private:
  double count_, done_ = 0;
  ProgressCallback whole_;
};

/// Writes a task's files. An interruption is heeded until the template is in its place, and no
/// longer: its preview then follows, so that there are both or neither.
void write_outputs(const Task& task, GlareTemplate& glare_template,
                   const TemplateArguments& arguments, const Console& console) {
  const auto keep_going = [] { return !interrupted(); };
  glare_template.recipe = task.recipe;
  if (arguments.half) warn_of_lost_digits(task.output.file, glare_template, console);
  const bool has_preview = !task.output.preview.empty();
  const auto png =
      has_preview ? encode_png_rgb8(preview(glare_template)) : std::vector<std::byte>();
  write_template(task.output.file, glare_template, {arguments.half, arguments.threads, keep_going});
  if (has_preview) write_file_atomically(task.output.preview, png);
}

/// The scale of a sequence's frames, for each lamp: the first frame's. Peaks that come and go would
/// make the others flicker.
class SequenceScale {
 public:
  void apply(GlareTemplate& frame, const std::string& lamp, bool is_dark) {
    if (frame.normalization != Normalization::peak || is_dark) return;
    const auto [scale, is_first] = per_steradian_.emplace(lamp, frame.per_steradian);
    if (!is_first) rescale(frame, scale->second);
  }

 private:
  std::map<std::string, double> per_steradian_;
};

/// Makes the templates one after the other.
void make_templates(const std::vector<Task>& tasks, const TemplateArguments& arguments,
                    TemplateOptions options, TemplateOptics& optics, SequenceScale& scale,
                    const Console& console) {
  Steps steps(tasks, console.progress("glare template"));
  for (auto task = tasks.begin(); task != tasks.end(); ++task) {
    const bool range_is_new = task == tasks.begin() || !(task->range == std::prev(task)->range);
    const ProgressCallback progress =
        range_is_new ? steps.next() : [](double) { return !interrupted(); };
    if (!optics.serves(task->range)) optics.make_far_field(task->range, progress);
    const auto is_served = [&](const Task& other) { return optics.serves(other.range); };
    const auto next_far_field = std::find_if_not(task, tasks.end(), is_served);
    const bool needs_aperture = options.aberrations.has_phase() || optics.is_dark();
    if (next_far_field == tasks.end() && !needs_aperture) optics.release_aperture();

    options.progress = steps.next();
    GlareTemplate made = made_template(optics, task->lamp, options);
    scale.apply(made, task->lamp.name, optics.is_dark());
    if (std::next(task) == next_far_field) optics.release_far_field();
    write_outputs(*task, made, arguments, console);
    tell_what_was_made(task->output.file, made, optics.aperture_size(), console);
  }
}

void make_frame(const TemplateArguments& arguments, const std::vector<NamedLamp>& lamps,
                SequenceScale& scale) {
  const Console console(arguments.verbosity());
  const TemplateOptions options = template_options(arguments);
  std::vector<Task> tasks = tasks_of(arguments, lamps, options);
  sort_by_range(tasks);

  TemplateOptics optics(arguments, options, console);
  for (const Task& task : tasks) optics.require_possible(task.range);
  RecipeWriter recipes(arguments);
  for (Task& task : tasks) task.recipe = recipes.recipe(task.lamp);
  make_templates(tasks, arguments, options, optics, scale, console);
}

void run_template(const TemplateArguments& arguments) {
  require_frame_in("--output", arguments.output, arguments.frames);
  require_frame_in("--preview", arguments.preview, arguments.frames);
  require_consistent(arguments);
  const std::vector<NamedLamp> lamps = read_lamps(arguments);
  SequenceScale scale;
  for (int i = 0; i < arguments.frames.count; ++i) {
    TemplateArguments frame = arguments;
    frame.eye.parameters.time_s += time_of_frame_s(arguments.frames, i);
    frame.output = with_frame(arguments.output, i);
    frame.preview = with_frame(arguments.preview, i);
    make_frame(frame, lamps, scale);
  }
}

}  // namespace

Command add_template_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "template",
      "Make a glare template for each lamp, from aperture images or, without, from the built-in "
      "eye");
  const auto arguments = std::make_shared<TemplateArguments>();
  add_template_options(command, *arguments);
  return [arguments] { run_template(*arguments); };
}

}  // namespace glare::tool
