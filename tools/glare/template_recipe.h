// The recipe that a template's file carries: how to make it again.
#pragma once

#include <string>

#include "glare/io/lamp_file.h"
#include "template_arguments.h"

namespace glare::tool {

/// A JSON object {"command": [...], "inputs": [{"option", "file", "sha256"}, ...]}: the command's
/// words with every option that bears on the pixels, defaults included (output names and the number
/// of threads don't), and a fingerprint of each file that was read. Throws `InputError` where one
/// can't be read any more.
std::string recipe(const TemplateArguments& arguments, const NamedLamp& lamp);

}  // namespace glare::tool
