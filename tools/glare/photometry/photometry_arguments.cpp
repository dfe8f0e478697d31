#include "photometry/photometry_arguments.h"

#include <CLI/CLI.hpp>
#include <vector>

#include "console.h"
#include "glare/base/error.h"
#include "glare/io/memory.h"
#include "glare/io/photometry_file.h"

namespace glare::tool {

void add_range_option(CLI::App& command, const std::string& name,
                      std::optional<std::array<double, 2>>& range, const std::string& help) {
  command
      .add_option_function<std::vector<double>>(
          name,
          [&range](const std::vector<double>& values) {
            range = {values[0], values[1]};
          },
          help)
      ->expected(2)
      ->type_name("LO HI");
}

void add_photometry_input(CLI::App& command, PhotometryInput& input, const std::string& prefix) {
  input.range_prefix = prefix;
  command
      .add_option("file", input.file,
                  "IES LM-63 or EULUMDAT file, or an image of one channel in candela")
      ->required();
  add_range_option(command, prefix + "h-deg", input.h_deg,
                   "Of an image: H of the centres of its first and last column (default: what the "
                   "file tells, as those of convert do)");
  add_range_option(command, prefix + "v-deg", input.v_deg,
                   "Of an image: V of the centres of its bottom and top row");
  command.add_option("--white-cd", input.white_cd,
                     "Of an image: candela of the value 1, such as 65535 for a 16-bit one that "
                     "holds candela");
  command
      .add_option("--lamp-set", input.lamp_set,
                  "Of EULUMDAT: which set of lamps, from 1 (default: the first)")
      ->check(CLI::Range(1, 1000));
  command.add_flag("--quiet", input.quiet, "No warnings");
}

PhotometricData photometry_from(const PhotometryInput& input) {
  const std::string h = input.range_prefix + "h-deg", v = input.range_prefix + "v-deg";
  if (input.h_deg.has_value() != input.v_deg.has_value())
    throw OptionError(h + " and " + v + " go together");
  try {
    PhotometricData data = read_photometry(
        input.file,
        {input.h_deg, input.v_deg, input.white_cd, input.lamp_set, default_memory_limit_bytes()});
    if (input.lamp_set && data.info.format != "EULUMDAT")
      throw OptionError("--lamp-set is for EULUMDAT files; " + input.file + " is " +
                        data.info.format);
    return data;
  } catch (const OptionError& error) {
    // Without any of these, only an image that doesn't tell its degrees is refused so.
    if (input.h_deg || input.white_cd || input.lamp_set) throw;
    throw OptionError(std::string(error.what()) + " (" + h + " LO HI, " + v + " LO HI)");
  }
}

void tell_warnings(const PhotometryInput& input, const PhotometricFileInfo& info) {
  const Console console(input.quiet ? Verbosity::quiet : Verbosity::normal);
  for (const std::string& warning : info.warnings) console.warn(input.file + ": " + warning);
}

}  // namespace glare::tool
