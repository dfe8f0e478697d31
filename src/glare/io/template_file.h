// Glare templates in OpenEXR files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "glare/template/glare_template.h"

namespace glare {

struct TemplateFileOptions {
  bool half = false;  ///< 16-bit instead of 32-bit floating point.
  /// For the compression; 0: as many as the machine has, and never more. OpenEXR compresses in one
  /// pool of threads that the whole process shares: where the pool has fewer it is grown for the
  /// time of the call.
  int threads = 0;
  std::function<bool()> keep_going;  ///< Asked between some rows; false stops with `Cancelled`.
};

/// The largest value that half precision holds.
inline constexpr float kLargestHalf = 65504;

/// Writes a template as docs/file-format.md describes: scan lines, ZIP, channels R G B (X Y Z for
/// colour space xyz), and every attribute. The file is complete or is not there. The same template
/// gives the same bytes. Throws `OutputError`; `OptionError` where half can't hold the values.
void write_template(const std::filesystem::path& path, const GlareTemplate& glare_template,
                    const TemplateFileOptions& options = {});

struct ReadTemplateOptions {
  std::uint64_t memory_limit_bytes = UINT64_MAX;  ///< For the file, its pixels and the decoder.
};

/// Reads a template back, from scan lines of any compression; its colour space is made from the
/// file's chromaticities. Throws `InputError`, which names the attribute or channel where one is
/// missing or not as it should be, and which tells where the file is damaged, tiled, deep or of
/// several parts; `MemoryError`, before anything is allocated for it.
GlareTemplate read_template(const std::filesystem::path& path,
                            const ReadTemplateOptions& options = {});

/// One attribute of a file's header, as text.
struct HeaderAttribute {
  std::string name;
  std::string type;   ///< OpenEXR's name of it: "float", "v2f", "string", ...
  std::string value;  ///< Numbers with spaces between; "(N bytes)" for types not written out.
};

/// Every attribute of the header of an OpenEXR file of scan lines, and each channel's pixel type as
/// an attribute "channel NAME". Throws `InputError`.
std::vector<HeaderAttribute> read_header(const std::filesystem::path& path);

struct TemplateFile {
  GlareTemplate glare_template;
  std::vector<HeaderAttribute> header;  ///< As `read_header` gives it.
};

/// The template and the header, of one reading. Throws as `read_template` does.
TemplateFile read_template_file(const std::filesystem::path& path,
                                const ReadTemplateOptions& options = {});

}  // namespace glare
