// The subcommands of the program.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace glare::tool {

/// Adds a subcommand and its options to the program. The function returned runs it; what it throws
/// becomes the program's message and exit status.
using Command = std::function<void()>;
Command add_template_command(CLI::App& program);
Command add_info_command(CLI::App& program);
Command add_lamps_command(CLI::App& program);
Command add_apply_command(CLI::App& program);
Command add_headlamp_command(CLI::App& program);
Command add_export_command(CLI::App& program);
Command add_tonemap_command(CLI::App& program);
Command add_aperture_command(CLI::App& program);
Command add_aperture_eye_command(CLI::App& aperture);
Command add_aperture_diaphragm_command(CLI::App& aperture);
Command add_aperture_photo_command(CLI::App& aperture);
Command add_photometry_command(CLI::App& program);
Command add_photometry_info_command(CLI::App& photometry);
Command add_photometry_convert_command(CLI::App& photometry);

}  // namespace glare::tool
