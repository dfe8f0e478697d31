#include "glare/io/lamp_file.h"

#include <string_view>
#include <system_error>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/spectrum/lamps.h"
#include "glare/spectrum/spectrum_table.h"

namespace glare {

namespace {

constexpr std::uint64_t kLargestTable_bytes = 64'000'000;

bool looks_like_a_path(const std::string& text) {
  return text.find('/') != std::string::npos || text.find('.') != std::string::npos;
}

}  // namespace

NamedLamp read_lamp_table(const std::filesystem::path& path) {
  const auto bytes = read_file(path, kLargestTable_bytes);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.find('\0') != std::string_view::npos)
    throw InputError(path.string(), "is not a text file of wavelength_nm,power rows");
  return {path.filename().string(), path, parse_lamp_table(text, path.string())};
}

NamedLamp lamp_from(const std::string& name_or_file) {
  if (auto built_in = find_lamp(name_or_file)) return {name_or_file, {}, *built_in};
  std::error_code ignored;
  if (!looks_like_a_path(name_or_file) && !std::filesystem::exists(name_or_file, ignored))
    throw OptionError("unknown lamp '" + name_or_file +
                      "'; expected a name from 'glare lamps', blackbody:KELVIN or a CSV file");
  return read_lamp_table(name_or_file);
}

}  // namespace glare
