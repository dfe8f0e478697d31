// The tables of a scene file that templates are made from.
#pragma once

#include "headlamp/toml_table.h"
#include "template/template_arguments.h"

namespace glare::tool {

/// [eye]: the built-in eye's options of glare template, or pictures of an aperture; and its
/// aberrations. Throws `InputError`.
void read_eye_table(const TomlTable& table, TemplateArguments& arguments);

/// [template]: its pixels, field, observer and scatter. Throws `InputError`.
void read_template_table(const TomlTable& table, TemplateArguments& arguments);

}  // namespace glare::tool
