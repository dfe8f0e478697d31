// The options of the built-in eye, of every command that draws it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "glare/aperture/eye.h"
#include "glare/aperture/pupil_diameter.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace glare::tool {

/// The eye as given or by default.
struct EyeArguments {
  EyeParameters parameters;
  std::optional<double> adapting_luminance_cd_m2;  ///< Given: the pupil's diameter follows from it.
  double field_area_deg2 = Adaptation{}.field_area_deg2;
  int adapting_eyes = Adaptation{}.eyes;
  bool clear_media = false;  ///< No particles, no fibres, no sutures.
};

/// Adds the options to a command, and returns them; `arguments` are set when it is parsed, and
/// outlive it.
std::vector<CLI::Option*> add_eye_model_options(CLI::App& command, EyeArguments& arguments);

/// The eye they mean. The age is that of the formula for the pupil's diameter. Throws `OptionError`
/// for a value outside its range.
EyeParameters eye_parameters(const EyeArguments& arguments, const std::optional<double>& age_years);

/// A number of the eye that is an option of its own: "--pupil-mm" and so on.
struct EyeNumber {
  std::string name;
  std::variant<double*, int*> value;
};

/// Every such number of these parameters.
std::vector<EyeNumber> eye_numbers(EyeParameters& eye);

/// An option with its values, as text that gives them back.
struct OptionText {
  std::string name;
  std::vector<std::string> values;
};

/// Every option that makes this eye again.
std::vector<OptionText> option_texts(const EyeParameters& eye);

/// A number in as few digits as give it back.
std::string text_of(double number);

}  // namespace glare::tool
