// glare apply: a picture, or a sequence, with the glare of its lights.

#include <CLI/CLI.hpp>
#include <memory>

#include "apply/apply_arguments.h"
#include "apply/apply_frames.h"
#include "apply/picture_glare.h"
#include "apply/picture_scale.h"
#include "commands.h"
#include "console.h"

namespace glare::tool {

namespace {

void run_apply(const ApplyArguments& arguments) {
  require_consistent(arguments);
  const Console console(arguments.verbosity());
  const std::vector<ApplyFrame> frames = apply_frames_of(arguments);
  require_files(frames, arguments);
  const GlareInputs inputs = read_glare_inputs(arguments);
  const PictureDocument first = read_document(frames.front(), arguments);
  const ScaledPicture scaled = scale_of(first, frames.front().input, arguments);
  for (const std::string& loss : first.losses(frames.front().output))
    console.warn(frames.front().output + ": " + loss);
  tell_scale(scaled, inputs.glare_template, first, arguments, console);
  write_frames_with_glare(frames, first, inputs, arguments, console);
}

}  // namespace

Command add_apply_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "apply", "Spread the light of a linear HDR picture, or a sequence, by a glare template");
  const auto arguments = std::make_shared<ApplyArguments>();
  add_apply_options(command, *arguments);
  return [arguments] { run_apply(*arguments); };
}

}  // namespace glare::tool
