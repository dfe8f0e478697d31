#include "aperture/eye_arguments.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace glare::tool {

namespace {

/// An option of one number.
struct NumberOption {
  std::string name, help;
  std::variant<double*, int*> value;
};
struct OptionGroup {
  const char* name;
  std::vector<NumberOption> options;
};

std::vector<NumberOption> lash_options(const std::string& lid, EyelashParameters& lashes) {
  const std::string begin = "--" + lid + "-lash";
  return {{begin + "es", "Lashes of the " + lid + " lid", &lashes.count},
          {begin + "-length-mm", "Length of the longest", &lashes.length_mm},
          {begin + "-root-width-mm", "Width of the thickest at its root", &lashes.root_width_mm},
          {begin + "-tip-share", "Width of the tip over that of the root", &lashes.tip_share},
          {begin + "-droop-deg", "Angle to the line of sight at the root", &lashes.droop_deg},
          {begin + "-curl-deg", "How far it turns away from root to tip", &lashes.curl_deg},
          {begin + "-fan-deg", "Angle to the vertical at the eye's corners", &lashes.fan_deg},
          {begin + "-scatter-deg", "Spread of the directions", &lashes.scatter_deg},
          {begin + "-clumping", "How far tips gather in tufts, 0 to 1", &lashes.clumping}};
}

void add_particle_options(const std::string& medium, MediumParticles& particles,
                          std::vector<NumberOption>& options) {
  const std::string begin = "--" + medium + "-particle";
  options.push_back(
      {begin + "s-per-mm2", "Particles in the " + medium + ", 0: none", &particles.number_per_mm2});
  options.push_back({begin + "-um", "Their median diameter", &particles.diameter_um});
  options.push_back(
      {begin + "-spread", "Spread of the diameter's logarithm", &particles.diameter_spread});
  options.push_back({begin + "-drift-mm-per-s", "Speed", &particles.drift_mm_per_s});
}

std::vector<NumberOption> media_options(EyeParameters& eye) {
  std::vector<NumberOption> options;
  add_particle_options("cornea", eye.particles.cornea, options);
  add_particle_options("lens", eye.particles.lens, options);
  add_particle_options("vitreous", eye.particles.vitreous, options);
  LensParameters& lens = eye.lens;
  options.insert(
      options.end(),
      {{"--fibre-pitch-um", "Distance of the lens's fibres", &lens.fibre_pitch_um},
       {"--fibre-pitch-variation", "Its full range over its mean", &lens.fibre_pitch_variation},
       {"--fibre-zone-inner-mm", "Radius where they begin to be seen", &lens.fibre_zone_inner_mm},
       {"--fibre-zone-outer-mm", "Radius where they end", &lens.fibre_zone_outer_mm},
       {"--fibre-modulation", "Of the amplitude, 0: no halo", &lens.fibre_modulation},
       {"--suture-branches", "Lines of the lens's star", &lens.suture_branches},
       {"--suture-length-mm", "Their length", &lens.suture_length_mm},
       {"--suture-width-um", "Their width", &lens.suture_width_um},
       {"--suture-contrast", "What they take of the amplitude", &lens.suture_contrast}});
  return options;
}

/// The options that are one number of the parameters.
std::vector<OptionGroup> number_options(EyeParameters& eye) {
  PupilParameters& pupil = eye.pupil;
  return {{"Built-in eye: pupil",
           {{"--pupil-mm", "Diameter", &pupil.diameter_mm},
            {"--pupil-axis-ratio", "Shorter axis over longer one", &pupil.axis_ratio},
            {"--pupil-longer-axis-deg", "Anticlockwise from the right", &pupil.longer_axis_deg},
            {"--pupil-right-mm", "Of the eye's axis", &pupil.decentring_x_mm},
            {"--pupil-down-mm", "Of the eye's axis", &pupil.decentring_y_mm},
            {"--pupil-crypts-mm", "Irregularity of 3 to 12 waves", &pupil.crypt_irregularity_mm},
            {"--pupil-ruff-mm", "Irregularity of 20 to 80 waves", &pupil.ruff_irregularity_mm}}},
          {"Built-in eye: lids and lashes",
           {{"--lid-opening-mm", "8 to 11 wide open, 2 to 4 squinting", &eye.eyelids.opening_mm},
            {"--lid-share-above", "Of the opening, above the axis", &eye.eyelids.share_above}}},
          {"Built-in eye: lids and lashes", lash_options("upper", eye.upper_lashes)},
          {"Built-in eye: lids and lashes", lash_options("lower", eye.lower_lashes)},
          {"Built-in eye: inside", media_options(eye)},
          {"Built-in eye: motion",
           {{"--hippus-mm", "Change of the pupil's diameter", &eye.motion.hippus_mm},
            {"--blinks-per-minute", "0: none", &eye.motion.blinks_per_minute},
            {"--time-s", "When; of a sequence, its beginning", &eye.time_s}}}};
}

void remove_media(EyeParameters& eye) {
  for (MediumParticles* particles :
       {&eye.particles.cornea, &eye.particles.lens, &eye.particles.vitreous})
    particles->number_per_mm2 = 0;
  eye.lens.fibre_modulation = 0;
  eye.lens.suture_contrast = 0;
}

std::vector<CLI::Option*> add_adaptation_options(CLI::App& command, EyeArguments& a,
                                                 CLI::Option* diameter) {
  const std::string group = "Built-in eye: pupil";
  auto* const luminance =
      command
          .add_option("--adapting-luminance-cd-m2", a.adapting_luminance_cd_m2,
                      "Instead of --pupil-mm: what the eye is adapted to; the pupil then follows "
                      "from it, the field, the age (--age) and the eyes (Watson and Yellott 2012)")
          ->excludes(diameter)
          ->group(group);
  auto* const area = command.add_option("--field-area-deg2", a.field_area_deg2, "Its field")
                         ->capture_default_str()
                         ->needs(luminance)
                         ->group(group);
  auto* const eyes = command.add_option("--adapting-eyes", a.adapting_eyes, "1 or 2 that see it")
                         ->capture_default_str()
                         ->needs(luminance)
                         ->group(group);
  return {luminance, area, eyes};
}

}  // namespace

std::vector<EyeNumber> eye_numbers(EyeParameters& eye) {
  std::vector<EyeNumber> numbers;
  for (const OptionGroup& group : number_options(eye))
    for (const NumberOption& option : group.options) numbers.push_back({option.name, option.value});
  return numbers;
}

std::vector<CLI::Option*> add_eye_model_options(CLI::App& command, EyeArguments& arguments) {
  std::vector<CLI::Option*> all;
  for (const OptionGroup& group : number_options(arguments.parameters))
    for (const NumberOption& option : group.options) {
      const auto add = [&](auto* value) {
        return command.add_option(option.name, *value, option.help);
      };
      all.push_back(std::visit(add, option.value)->capture_default_str()->group(group.name));
    }
  const auto adaptation = add_adaptation_options(command, arguments, all.front());
  all.insert(all.end(), adaptation.begin(), adaptation.end());
  all.push_back(command
                    .add_flag("--clear-media", arguments.clear_media,
                              "Nothing inside the eye: no particles, fibres, sutures")
                    ->group("Built-in eye: inside"));
  const auto whole_number = [](std::string& text) {  // CLI11 would let it wrap around.
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc{} && stop == end ? "" : "'" + text + "' isn't a whole number";
  };
  all.push_back(command.add_option("--seed", arguments.parameters.seed, "Which eye of all")
                    ->check(CLI::Validator(whole_number, ""))
                    ->capture_default_str()
                    ->group("Built-in eye: pupil"));
  return all;
}

EyeParameters eye_parameters(const EyeArguments& arguments,
                             const std::optional<double>& age_years) {
  EyeParameters eye = arguments.parameters;
  if (arguments.adapting_luminance_cd_m2)
    eye.pupil.diameter_mm =
        pupil_diameter_mm({*arguments.adapting_luminance_cd_m2, arguments.field_area_deg2,
                           age_years.value_or(Adaptation{}.age_years), arguments.adapting_eyes});
  if (arguments.clear_media) remove_media(eye);
  require_valid(eye);
  return eye;
}

std::vector<OptionText> option_texts(const EyeParameters& eye) {
  EyeParameters parameters = eye;
  std::vector<OptionText> texts = {{"--seed", {std::to_string(eye.seed)}}};
  for (const OptionGroup& group : number_options(parameters))
    for (const NumberOption& option : group.options) {
      const auto text = [](const auto* value) { return text_of(static_cast<double>(*value)); };
      texts.push_back({option.name, {std::visit(text, option.value)}});
    }
  return texts;
}

std::string text_of(double number) {
  char text[40];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    if (std::strtod(text, nullptr) == number) break;
  }
  return text;
}

}  // namespace glare::tool
