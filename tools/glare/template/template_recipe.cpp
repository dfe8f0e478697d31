#include "template/template_recipe.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "glare/io/sha256.h"
#include "glare/spectrum/lamps.h"

namespace glare::tool {

namespace {

/// An option as it took effect, and the file it names, if any.
struct RecipeOption {
  std::string name;  ///< "--lamp"
  std::vector<std::string> values;
  std::filesystem::path file;  ///< Empty where the option names no file.
};

std::vector<RecipeOption> recipe_options(const TemplateArguments& a, const NamedLamp& lamp) {
  std::vector<RecipeOption> options;
  const auto add_file = [&](const char* name, const std::filesystem::path& file) {
    if (!file.empty()) options.push_back({name, {file.filename().string()}, file});
  };
  add_file("--pupil", a.pupil);
  add_file("--eyelashes", a.eyelashes);
  if (a.has_images()) {
    if (a.width_mm) options.push_back({"--width-mm", {text_of(*a.width_mm)}, {}});
  } else {
    for (const OptionText& text : option_texts(a.eye_parameters()))
      options.push_back({text.name, text.values, {}});
  }
  if (a.scatter == "cie") {
    const Straylight eye = eye_of(a.age_years, a.pigment);
    options.push_back({"--scatter", {a.scatter}, {}});
    options.push_back({"--age", {text_of(eye.age_years)}, {}});
    options.push_back({"--pigment", {text_of(eye.pigment)}, {}});
  }
  if (a.defocus_dioptre != 0) options.push_back({"--defocus-d", {text_of(a.defocus_dioptre)}, {}});
  add_file("--zernike", a.zernike);
  if (a.chromatic) {
    options.push_back({"--chromatic-aberration", {}, {}});
    options.push_back({"--focused-nm", {text_of(a.focused_nm)}, {}});
  }
  if (a.stiles_crawford) {
    options.push_back({"--stiles-crawford", {}, {}});
    options.push_back(
        {"--stiles-crawford-rho-per-mm2", {text_of(a.stiles_crawford_rho_per_mm2)}, {}});
    options.push_back(
        {"--stiles-crawford-peak-mm",
         {text_of(a.stiles_crawford_peak_mm[0]), text_of(a.stiles_crawford_peak_mm[1])},
         {}});
  }
  // A file that is named like a built-in lamp is told from it by its folder.
  const bool ambiguous = !lamp.file.empty() && find_lamp(lamp.name).has_value();
  options.push_back({"--lamp", {(ambiguous ? "./" : "") + lamp.name}, lamp.file});
  options.push_back({"--observer", {a.observer}, {}});
  options.push_back({"--wavelength-range-nm",
                     {text_of(a.wavelength_range_nm[0]), text_of(a.wavelength_range_nm[1])},
                     {}});
  options.push_back({"--size", {a.size}, {}});
  options.push_back({"--fov-deg", {text_of(a.fov_deg)}, {}});
  options.push_back({"--colorspace", {a.color_space}, {}});
  const std::filesystem::path config = user_color_config(a);
  std::error_code ignored;
  if (std::filesystem::is_regular_file(config, ignored))
    add_file("--ocio", config);
  else if (!config.empty())  // A name such as ocio://default.
    options.push_back({"--ocio", {config.string()}, {}});
  options.push_back({"--white", {a.white}, {}});
  options.push_back({"--normalize", {a.normalize}, {}});
  options.push_back({"--gamut", {a.gamut}, {}});
  if (a.half) options.push_back({"--half", {}, {}});
  return options;
}

}  // namespace

std::string RecipeWriter::recipe(const NamedLamp& lamp) {
  nlohmann::ordered_json command = {"glare", "template"};
  nlohmann::ordered_json inputs = nlohmann::ordered_json::array();
  for (const RecipeOption& option : recipe_options(arguments_, lamp)) {
    command.push_back(option.name);
    for (const std::string& value : option.values) command.push_back(value);
    if (!option.file.empty())
      inputs.push_back({{"option", option.name},
                        {"file", option.file.filename().string()},
                        {"sha256", fingerprint_of(option.file)}});
  }
  const nlohmann::ordered_json whole = {{"command", command}, {"inputs", inputs}};
  return whole.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

const std::string& RecipeWriter::fingerprint_of(const std::filesystem::path& file) {
  std::string& fingerprint = fingerprints_[file];
  if (fingerprint.empty()) fingerprint = sha256_of_file(file);
  return fingerprint;
}

}  // namespace glare::tool
