// glare headlamp: what the driver of an oncoming car sees of lamps, as pictures and in numbers.

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "commands.h"
#include "console.h"
#include "file_names.h"
#include "frames.h"
#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/memory.h"
#include "glare/io/sha256.h"
#include "glare/spectrum/lamps.h"
#include "headlamp/frame_maker.h"
#include "headlamp/headlamp_arguments.h"
#include "headlamp/report.h"
#include "headlamp/scene.h"
#include "headlamp/scene_notes.h"
#include "headlamp/sequence.h"

namespace glare::tool {

namespace {

namespace fs = std::filesystem;

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

/// The scene with what the command line says of it.
Scene scene_from(const HeadlampArguments& arguments) {
  Scene scene = read_scene(arguments.scene);
  if (!arguments.mode.empty())
    scene.mode = arguments.mode == "paper" ? SceneMode::paper : SceneMode::physical;
  if (arguments.relative_luminance && scene.mode != SceneMode::paper)
    throw OptionError("--l0 goes with --mode paper");
  for (SceneLamp& lamp : scene.lamps)
    if (arguments.relative_luminance) lamp.relative_luminance = arguments.relative_luminance;
  scene.template_arguments.threads = arguments.threads;
  scene.template_arguments.memory_limit_bytes = arguments.memory_limit_bytes;
  return scene;
}

/// Everything that the command reads.
std::vector<fs::path> inputs_of(const Scene& scene, const Backgrounds& backgrounds, int frames) {
  std::vector<fs::path> inputs = backgrounds.files(frames);
  const TemplateArguments& eye = scene.template_arguments;
  for (const std::string& file : {scene.file.string(), eye.pupil, eye.eyelashes, eye.zernike,
                                  scene.tone_mapping.config.string()})
    if (!file.empty()) inputs.emplace_back(file);
  for (const SceneLamp& lamp : scene.lamps)
    for (const fs::path& file : {lamp.intensity, lamp.glare_template, fs::path(lamp.spectrum)})
      if (!file.empty() && !find_lamp(file.string())) inputs.push_back(file);
  return inputs;
}

void require_different_files(const std::vector<fs::path>& inputs,
                             const std::vector<SceneFrame>& frames,
                             const HeadlampArguments& arguments) {
  std::set<fs::path> read, written;
  for (const fs::path& input : inputs) read.insert(canonical(input.string()));
  const auto take = [&](const std::string& file) {
    if (read.contains(canonical(file)))
      throw OptionError("the output " + file + " is an input too");
    if (!written.insert(canonical(file)).second)
      throw OptionError("two outputs are the same file, " + file);
  };
  for (const std::string& report : arguments.reports) take(report);
  if (arguments.output.empty()) return;
  for (const SceneFrame& frame : frames) take(with_frame(arguments.output, frame.index));
  if (frames.size() > 1) take(FrameRecord(arguments.output).file().string());
}

/// Of all that frames are made from, but for the backgrounds and what changes from one to another.
std::string fingerprint_of(const SceneParts& parts, const HeadlampArguments& arguments) {
  nlohmann::ordered_json all = {{"software", "glare " GLARE_VERSION},
                                {"scene", sha256_of_file(parts.scene.file)},
                                {"paper", parts.scene.mode == SceneMode::paper},
                                {"exr", arguments.writes_exr()},
                                {"bits", arguments.bits},
                                {"half", arguments.half},
                                {"display", parts.display.description()},
                                {"lamps", nlohmann::ordered_json::array()}};
  if (arguments.relative_luminance) all["l0"] = *arguments.relative_luminance;
  for (std::size_t i = 0; i < parts.scene.lamps.size(); ++i)
    all["lamps"].push_back({parts.lights.sha256(i), parts.templates.of_lamp(i).sha256});
  return sha256_of(bytes_of(all.dump()));
}

void write_reports(const SceneParts& parts, const std::vector<SceneFrame>& frames,
                   const HeadlampArguments& arguments) {
  if (arguments.reports.empty()) return;
  const Report report = report_of(parts, frames, arguments.report_angles_deg);
  for (const std::string& file : arguments.reports)
    write_file_atomically(file,
                          bytes_of(ending_of(file) == ".json" ? json_of(report) : csv_of(report)));
}

void run_headlamp(const HeadlampArguments& arguments) {
  const Console console(arguments.verbosity());
  require_consistent(arguments);
  const Scene scene = scene_from(arguments);
  const std::vector<SceneFrame> frames = frames_of(
      scene, arguments.angles.empty() ? std::vector<double>() : turns_from(arguments.angles));
  const std::uint64_t limit =
      arguments.memory_limit_bytes ? arguments.memory_limit_bytes : default_memory_limit_bytes();
  const int count = static_cast<int>(frames.size());
  const Backgrounds backgrounds(scene, count, limit, console);
  require_frame_in("--output", arguments.output, {count, 1});
  require_different_files(inputs_of(scene, backgrounds, count), frames, arguments);
  require_outputs(frames, backgrounds.camera(), arguments);
  for (const std::string& report : arguments.reports) require_writable(report);
  const SceneLights lights(scene, limit, console);
  for (const SceneFrame& frame : frames)
    for (std::size_t lamp = 0; lamp < scene.lamps.size(); ++lamp)
      lights.light(lamp, backgrounds.camera(), frame);
  const SceneDisplay display(scene, backgrounds);
  SceneTemplates templates(scene, console, arguments.template_cache);
  if (arguments.check) return backgrounds.require_all(count);

  templates.make();
  const SceneParts parts{scene, backgrounds, lights, templates, display};
  warn_of_dark_lamps(parts, frames, console);
  if (!arguments.output.empty()) warn_of_borders(parts, frames, console);
  if (!arguments.output.empty())
    write_frames(FrameMaker(parts), parts, frames, fingerprint_of(parts, arguments), arguments,
                 console);
  write_reports(parts, frames, arguments);
}

}  // namespace

Command add_headlamp_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "headlamp", "Make pictures and a report of what a driver sees of a scene's lamps");
  const auto arguments = std::make_shared<HeadlampArguments>();
  add_headlamp_options(command, *arguments);
  return [arguments] { run_headlamp(*arguments); };
}

}  // namespace glare::tool
