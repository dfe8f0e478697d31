// The files that glare template writes.
#pragma once

#include <string>
#include <vector>

#include "template/template_arguments.h"

namespace glare::tool {

/// Where a lamp's template goes.
struct TemplateOutput {
  std::string file;
  std::string preview;  ///< Empty where none is asked for.
};

/// The outputs of every lamp of the arguments, in their order. In `--output` and `--preview`
/// "{lamp}" stands for the lamp: its name or, for a file, the name without folder and last ending,
/// with a hyphen for each character that file systems keep for themselves (/ \ : * ? " < > | and
/// control characters).
///
/// Throws `OptionError` where several lamps have no "{lamp}" to tell them apart or have the same
/// name (capitals don't count, as on some file systems), where an output is an input or another
/// output, or has the ending of another kind of file; `OutputError` where one can't be written.
std::vector<TemplateOutput> template_outputs(const TemplateArguments& arguments);

}  // namespace glare::tool
