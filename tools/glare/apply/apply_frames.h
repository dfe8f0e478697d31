// The pictures of one command: one, or the frames of a sequence.
#pragma once

#include <string>
#include <vector>

#include "apply/apply_arguments.h"
#include "apply/picture_glare.h"
#include "glare/io/picture_document.h"

namespace glare::tool {

struct ApplyFrame {
  int number = 0;
  std::string input, output;
};

/// One for each number of --frames, else the one picture. Throws `OptionError`.
std::vector<ApplyFrame> apply_frames_of(const ApplyArguments& arguments);

/// Before any work: throws `InputError` for a frame of a sequence that isn't there, `OptionError`
/// where an output is an input or another output, `OutputError` where one can't be written.
void require_files(const std::vector<ApplyFrame>& frames, const ApplyArguments& arguments);

/// A picture with all else of its file. Throws as `PictureDocument::read` does.
PictureDocument read_document(const ApplyFrame& frame, const ApplyArguments& arguments);

/// Writes every frame with its glare; those of a sequence side by side, as many as the cores and
/// the memory allow, with a record of those that are finished. `first` is the first frame's
/// content. Throws as `PictureGlare::apply` and `PictureDocument` do.
void write_frames_with_glare(const std::vector<ApplyFrame>& frames, const PictureDocument& first,
                             const GlareInputs& inputs, const ApplyArguments& arguments,
                             const Console& console);

}  // namespace glare::tool
