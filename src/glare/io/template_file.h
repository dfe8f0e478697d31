// Glare templates in OpenEXR files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "glare/template/glare_template.h"

namespace glare {

struct TemplateFileOptions {
  bool half = false;                 ///< 16-bit instead of 32-bit floating point.
  int threads = 0;                   ///< For the compression; 0: as many as the machine has.
  std::function<bool()> keep_going;  ///< Asked between steps; false stops with `Cancelled`.
};

/// The largest value that half precision holds.
inline constexpr float kLargestHalf = 65504;

/// Writes a template as docs/file-format.md describes: scan lines, ZIP, channels R G B (X Y Z for
/// colour space xyz), and every attribute. The file is complete or is not there. The same template
/// gives the same bytes. Throws `OutputError`; `OptionError` where half can't hold the values.
void write_template(const std::filesystem::path& path, const GlareTemplate& glare_template,
                    const TemplateFileOptions& options = {});

/// Reads a template back. Throws `InputError`, which names the attribute or channel where one is
/// missing or not as it should be.
GlareTemplate read_template(const std::filesystem::path& path);

/// One attribute of a file's header, as text.
struct HeaderAttribute {
  std::string name;
  std::string type;  ///< OpenEXR's name of it: "float", "v2f", "string", ...
  std::string value;
};

/// Every attribute of an OpenEXR file's header, and each channel's pixel type as an attribute
/// "channel NAME". Throws `InputError`.
std::vector<HeaderAttribute> read_header(const std::filesystem::path& path);

}  // namespace glare
