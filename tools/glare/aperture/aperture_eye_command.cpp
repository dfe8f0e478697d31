// glare aperture eye: pictures of the built-in eye.

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aperture/aperture_outputs.h"
#include "aperture/eye_arguments.h"
#include "commands.h"
#include "frames.h"
#include "glare/base/error.h"
#include "glare/io/aperture_file.h"
#include "interruption.h"

namespace glare::tool {

namespace {

struct EyePictureArguments {
  EyeArguments eye;
  std::optional<double> age_years;
  FrameArguments frames;
  DrawingArguments drawing;
  std::string whole, pupil, eyelashes;
};

/// A picture to be written.
struct EyePicture {
  const char* option;
  const std::string& file;
  EyeView view;
};

std::vector<EyePicture> pictures_of(const EyePictureArguments& a) {
  std::vector<EyePicture> pictures;
  for (const EyePicture& picture : {EyePicture{"--output", a.whole, EyeView::whole},
                                    EyePicture{"--pupil-out", a.pupil, EyeView::pupil},
                                    EyePicture{"--eyelashes-out", a.eyelashes, EyeView::eyelashes}})
    if (!picture.file.empty()) pictures.push_back(picture);
  if (pictures.empty())
    throw OptionError("expected an output: --output, --pupil-out or --eyelashes-out");
  return pictures;
}

void require_possible(const std::vector<EyePicture>& pictures, const FrameArguments& frames) {
  for (const EyePicture& picture : pictures) require_frame_in(picture.option, picture.file, frames);
  std::vector<std::string> files;
  for (const EyePicture& picture : pictures) files.push_back(with_frame(picture.file, 0));
  require_pictures(files);
}

void run_eye(const EyePictureArguments& a) {
  const std::vector<EyePicture> pictures = pictures_of(a);
  require_possible(pictures, a.frames);
  EyeParameters eye = eye_parameters(a.eye, a.age_years);
  const double begin_s = eye.time_s;
  const double pixel = pixel_mm(a.drawing, eye_picture_width_mm(eye));
  const ProgressCallback progress = Console(a.drawing.verbosity()).progress("glare aperture eye");
  const double steps = static_cast<double>(pictures.size()) * a.frames.count;
  double done = 0;
  for (int frame = 0; frame < a.frames.count; ++frame) {
    eye.time_s = begin_s + time_of_frame_s(a.frames, frame);
    std::vector<OptionText> options = option_texts(eye);
    for (const EyePicture& picture : pictures) {
      const auto part = progress_part(progress, done / steps, (done + 1) / steps);
      const Aperture drawn = draw_eye(eye, pixel, a.drawing.threads, part, picture.view);
      std::vector<OptionText> all = options;
      all.push_back({"--size", {std::to_string(drawn.transmittance.width())}});
      write_aperture(with_frame(picture.file, frame), drawn, aperture_recipe("eye", all),
                     [] { return !interrupted(); });
      ++done;
    }
  }
}

}  // namespace

Command add_aperture_eye_command(CLI::App& aperture) {
  CLI::App& command =
      *aperture.add_subcommand("eye", "Draw the built-in eye: pupil, lids, eyelashes");
  const auto arguments = std::make_shared<EyePictureArguments>();
  EyePictureArguments& a = *arguments;
  const std::string kind = ": OpenEXR (.exr) or 16-bit PNG (.png)";
  command.add_option("-o,--output", a.whole, "The whole eye" + kind);
  command.add_option("--pupil-out", a.pupil, "The pupil, and what is inside the eye" + kind);
  command.add_option("--eyelashes-out", a.eyelashes, "Lids and lashes" + kind);
  add_drawing_options(command, a.drawing);
  command.add_option("--age", a.age_years, "In years, 20 to 83, for --adapting-luminance-cd-m2");
  add_eye_model_options(command, a.eye);
  add_frame_options(command, a.frames);
  return [arguments] { run_eye(*arguments); };
}

}  // namespace glare::tool
