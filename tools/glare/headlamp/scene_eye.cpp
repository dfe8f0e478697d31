#include "headlamp/scene_eye.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "glare/base/error.h"
#include "glare/spectrum/observer.h"

namespace glare::tool {

namespace {

constexpr NumberRange kAny{-1e6, 1e6};
constexpr NumberRange kWhole{0, std::numeric_limits<int>::max()};
constexpr double kLargestSeed = 9007199254740992;  // 2^53: whole in double precision.

/// "--pupil-mm" as a key: pupil_mm.
std::string key_of(const std::string& option) {
  std::string key = option.substr(2);
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

/// The numbers of the built-in eye that the table has; the last one's key, or nothing.
std::string read_eye_numbers(const TomlTable& table, EyeParameters& eye) {
  std::string given;
  for (const EyeNumber& number : eye_numbers(eye)) {
    const std::string key = key_of(number.name);
    if (!table.has(key)) continue;
    given = key;
    if (double* const* value = std::get_if<double*>(&number.value))
      **value = *table.number(key, kAny);
    else
      *std::get<int*>(number.value) = *table.whole_number(key, kWhole);
  }
  return given;
}

void read_adaptation(const TomlTable& table, EyeArguments& eye) {
  eye.adapting_luminance_cd_m2 = table.number("adapting_luminance_cd_m2", {1e-9, 1e9});
  eye.field_area_deg2 = table.number("field_area_deg2", {1e-6, 1e6}).value_or(eye.field_area_deg2);
  eye.adapting_eyes = table.whole_number("adapting_eyes", {1, 2}).value_or(eye.adapting_eyes);
  if (eye.adapting_luminance_cd_m2 && table.has("pupil_mm"))
    throw InputError(table.place_of("adapting_luminance_cd_m2"),
                     "adapting_luminance_cd_m2 and pupil_mm exclude one another");
}

void read_built_in_eye(const TomlTable& table, EyeArguments& eye) {
  read_eye_numbers(table, eye.parameters);
  read_adaptation(table, eye);
  eye.clear_media = table.truth("clear_media").value_or(false);
  const auto seed = table.number("seed", {0, kLargestSeed});
  if (seed && std::floor(*seed) != *seed)
    throw InputError(table.place_of("seed"), "seed: expected a whole number");
  if (seed) eye.parameters.seed = static_cast<std::uint64_t>(*seed);
}

void read_pictures(const TomlTable& table, TemplateArguments& a) {
  const auto text_of_file = [&](const std::string& key) {
    const auto file = table.file(key);
    return file ? file->string() : std::string();
  };
  a.pupil = text_of_file("pupil");
  a.eyelashes = text_of_file("eyelashes");
  a.width_mm = table.number("width_mm", {1e-6, 1e6});
  a.zernike = text_of_file("zernike");
  if (a.width_mm && !a.has_images())
    throw InputError(table.place_of("width_mm"), "width_mm goes with pupil or eyelashes");
}

void read_aberrations(const TomlTable& table, TemplateArguments& a) {
  a.defocus_dioptre = table.number("defocus_d", kAny).value_or(0);
  a.chromatic = table.truth("chromatic_aberration").value_or(false);
  a.focused_nm = table.number("focused_nm", {1, 1e5}).value_or(a.focused_nm);
  a.stiles_crawford = table.truth("stiles_crawford").value_or(false);
}

}  // namespace

void read_eye_table(const TomlTable& table, TemplateArguments& arguments) {
  read_pictures(table, arguments);
  read_aberrations(table, arguments);
  read_built_in_eye(table, arguments.eye);
  table.require_all_keys_known();
  EyeParameters none;
  const std::string number = read_eye_numbers(table, none);
  if (arguments.has_images() && !number.empty())
    throw InputError(table.place_of(number),
                     number + " is of the built-in eye, and excludes pupil and eyelashes");
  try {
    arguments.eye_parameters();
  } catch (const OptionError& error) {
    throw InputError(table.place(), "[eye]: " + std::string(error.what()));
  }
}

void read_template_table(const TomlTable& table, TemplateArguments& a) {
  a.size = "1024";
  if (const auto size = table.size("size_px", {1, 65535}))
    a.size = std::to_string((*size)[0]) + "x" + std::to_string((*size)[1]);
  a.fov_deg = table.number("fov_deg", {1e-6, 114}).value_or(20);
  if (const auto observer = table.word("observer", observer_names())) a.observer = *observer;
  if (const auto range = table.numbers("wavelength_range_nm", 2, {1, 1e5}))
    a.wavelength_range_nm = *range;
  a.scatter = table.word("scatter", {"none", "cie"}).value_or("none");
  a.gamut = table.word("gamut", {"keep", "desaturate"}).value_or("keep");
  a.normalize = "absolute";
  table.require_all_keys_known();
}

}  // namespace glare::tool
