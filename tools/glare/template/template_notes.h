// What glare template says about a lamp and about what it made.
#pragma once

#include <optional>
#include <string>

#include "console.h"
#include "glare/io/lamp_file.h"
#include "glare/template/make_template.h"

namespace glare::tool {

/// A warning where the lamp's table leaves out much of what the observer sees.
std::optional<std::string> missed_light(const NamedLamp& lamp, const TemplateOptions& options);

/// Warns where half precision, in the file of that name, has too few digits for many pixels.
void warn_of_lost_digits(const std::string& file, const GlareTemplate& glare_template,
                         const Console& console);

/// One line with the file's name, the lamp and the numbers of a template that was made.
void tell_what_was_made(const std::string& file, const GlareTemplate& glare_template,
                        const ApertureSize& aperture, const Console& console);

}  // namespace glare::tool
