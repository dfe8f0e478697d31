#include "headlamp/headlamp_arguments.h"

#include <CLI/CLI.hpp>
#include <set>

#include "common_options.h"
#include "file_names.h"
#include "glare/base/error.h"

namespace glare::tool {

namespace {

void add_output_options(CLI::App& command, HeadlampArguments& a) {
  command
      .add_option("-o,--output", a.output,
                  "Picture to write: .png, for a display, or .exr, linear, in cd/m2; {frame} in it "
                  "stands for the frame's number, from 0001 on, and sequences need it")
      ->check(not_empty());
  command
      .add_option("--report", a.reports,
                  "File of light and glare of each frame and lamp, .csv or .json; may be given "
                  "several times")
      ->allow_extra_args(false)
      ->type_name("TEXT")
      ->check(not_empty());
  command
      .add_option("--report-angles", a.report_angles_deg,
                  "Angles from the lamp, in degrees, at which its veil is reported: A,B,...")
      ->delimiter(',')
      ->type_name("A,B,...")
      ->default_str("1,2,5,10");
  command.add_option("--bits", a.bits, "Of a PNG; 8 are dithered, 16 rounded")
      ->check(CLI::IsMember({8, 16}))
      ->capture_default_str();
  command.add_flag("--half", a.half, "16-bit instead of 32-bit floating point, for .exr");
}

void add_scene_options(CLI::App& command, HeadlampArguments& a) {
  command.add_option("scene", a.scene, "Scene file (TOML); docs/headlamps.md tells its keys")
      ->required()
      ->check(not_empty())
      ->type_name("SCENE.toml");
  command
      .add_option("--angles", a.angles,
                  "A frame for each turn, in degrees to their right, of all vehicles and of lamps "
                  "without one: LO:HI:STEP, HI included, or A,B,C")
      ->check(not_empty());
  command
      .add_option("--mode", a.mode,
                  "physical: cd/m2; paper: relative luminance L0 x template (default: the scene's)")
      ->check(CLI::IsMember({"physical", "paper"}));
  command.add_option("--l0", a.relative_luminance,
                     "With --mode paper: every lamp's L0, instead of intensity over the reference");
}

}  // namespace

bool HeadlampArguments::writes_exr() const { return ending_of(output) == ".exr"; }

void add_headlamp_options(CLI::App& command, HeadlampArguments& a) {
  add_scene_options(command, a);
  add_output_options(command, a);
  command.add_flag("--resume", a.resume,
                   "Keep the frames of an interrupted sequence that are whole and of this scene");
  command.add_flag("--check", a.check, "Check the scene and everything it names; make nothing");
  command
      .add_option("--template-cache", a.template_cache,
                  "Folder of the templates that scenes' spectra need (default: glare/templates in "
                  "$XDG_CACHE_HOME or ~/.cache)")
      ->check(not_empty());
  add_threads_option(command, a.threads);
  add_memory_limit_option(command, a.memory_limit_bytes);
  add_verbosity_options(command, a.quiet, a.verbose);
}

void require_consistent(const HeadlampArguments& a) {
  if (a.output.empty() && a.reports.empty() && !a.check)
    throw OptionError("expected --output, --report or --check");
  const std::string ending = ending_of(a.output);
  if (!a.output.empty() && ending != ".png" && ending != ".exr")
    throw OptionError("--output " + a.output + ": expected a name that ends in .png or .exr");
  for (const std::string& report : a.reports)
    if (ending_of(report) != ".csv" && ending_of(report) != ".json")
      throw OptionError("--report " + report + ": expected a name that ends in .csv or .json");
  if (a.resume && a.output.empty()) throw OptionError("--resume goes with --output");
  if (a.half && !a.writes_exr()) throw OptionError("--half goes with an --output of .exr");
  if (a.bits != 8 && ending != ".png") throw OptionError("--bits goes with an --output of .png");
  if (a.relative_luminance && !(*a.relative_luminance >= 0 && *a.relative_luminance <= 1e12))
    throw OptionError("--l0 is out of range: expected 0 to 1e12");
  if (a.report_angles_deg.size() > 100) throw OptionError("--report-angles: at most 100");
  for (const double angle : a.report_angles_deg)
    if (!(angle > 0 && angle <= 90))
      throw OptionError("--report-angles: expected numbers above 0 and up to 90");
  const std::set<double> different(a.report_angles_deg.begin(), a.report_angles_deg.end());
  if (different.size() != a.report_angles_deg.size())
    throw OptionError("--report-angles: an angle is given twice");
}

}  // namespace glare::tool
