// glare aperture photo: apertures from a photograph of an eye.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "aperture/aperture_outputs.h"
#include "commands.h"
#include "console.h"
#include "file_names.h"
#include "glare/base/error.h"
#include "glare/glare_io.h"
#include "interruption.h"

namespace glare::tool {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct PhotoArguments {
  std::string input, pupil_out, eyelashes_out, check, mask_out;
  bool as_json = false, quiet = false, flip = false;
  std::vector<double> pupil_at, region, shift = {0, 0};
  std::optional<double> iris_mm, pupil_mm, mm_per_px, pixel_um;
  double width_mm = 8;
  int size = 2048;
};

struct Output {
  const char* option;
  std::string path;
  std::vector<std::byte> bytes;
};

/// What is asked for, in the order of the options.
std::vector<Output> outputs_of(const PhotoArguments& a) {
  std::vector<Output> outputs;
  for (const auto& [option, path] :
       {std::pair{"--pupil-out", a.pupil_out}, std::pair{"--eyelashes-out", a.eyelashes_out},
        std::pair{"--check", a.check}, std::pair{"--mask-out", a.mask_out}})
    if (!path.empty()) outputs.push_back({option, path, {}});
  return outputs;
}

void require_possible(const std::vector<Output>& outputs, const PhotoArguments& a) {
  if (outputs.empty() && !a.as_json)
    throw OptionError(
        "expected an output: --pupil-out, --eyelashes-out, --check, --mask-out or --json");
  std::vector<fs::path> taken = {canonical(a.input)};
  for (const Output& output : outputs) {
    const fs::path path = canonical(output.path);
    if (path == taken.front()) throw OptionError("the output " + output.path + " is the input too");
    if (std::find(taken.begin(), taken.end(), path) != taken.end())
      throw OptionError(std::string(output.option) + " " + output.path +
                        ": another output has the same name");
    taken.push_back(path);
    if (ending_of(output.path) != ".png")
      throw OptionError(std::string(output.option) + " " + output.path +
                        ": expected a name that ends in .png");
    require_writable(output.path);
  }
}

EyePhotoOptions options_of(const PhotoArguments& a) {
  EyePhotoOptions options;
  if (!a.pupil_at.empty()) options.pupil_at_px = {a.pupil_at[0], a.pupil_at[1]};
  if (!a.region.empty())
    options.lashes_region_px = PixelRectangle{a.region[0], a.region[1], a.region[2], a.region[3]};
  options.flip_lashes = a.flip;
  options.lashes_shift_mm = {a.shift[0], a.shift[1]};
  options.iris_mm = a.iris_mm.value_or(options.iris_mm);
  options.pupil_mm = a.pupil_mm;
  options.mm_per_px = a.mm_per_px;
  options.width_mm = a.width_mm;
  options.size = a.size;
  if (a.pixel_um) {
    if (!(*a.pixel_um > 0.01 && *a.pixel_um < 1e4))
      throw OptionError("--pixel-um must be from 0.01 to 10000");
    options.size =
        static_cast<int>(std::min(1e6, std::ceil(1000 * a.width_mm / *a.pixel_um - 1e-9)));
    options.width_mm = options.size * *a.pixel_um / 1000;  // A whole number of such pixels.
  }
  options.memory_limit_bytes = default_memory_limit_bytes();
  return options;
}

Json as_json(const EyePhoto& eye, const PhotoArguments& a, const RgbImage& photograph) {
  const bool iris = eye.iris_diameter_px > 0;
  const auto open = std::count(eye.mask.values().begin(), eye.mask.values().end(), 255);
  return {{"file", a.input},
          {"size_px", {photograph.width(), photograph.height()}},
          {"confidence", eye.confidence},
          {"center_px", eye.pupil_center_px},
          {"axes_px", eye.pupil_axes_px},
          {"angle_deg", eye.pupil_angle_deg},
          {"mask_area_px", open},
          {"pupil_diameter_mm", eye.pupil_diameter_mm()},
          {"mm_per_px", eye.mm_per_px},
          {"scale_from", a.mm_per_px  ? "mm_per_px"
                         : a.pupil_mm ? "pupil_mm"
                                      : "iris_mm"},
          {"iris_center_px", iris ? Json(eye.iris_center_px) : Json()},
          {"iris_diameter_px", iris ? Json(eye.iris_diameter_px) : Json()},
          {"iris_confidence", eye.iris_confidence},
          {"aperture_width_mm", eye.pupil.width_mm},
          {"aperture_size_px", eye.pupil.transmittance.width()}};
}

std::string recipe_of(const PhotoArguments& a, const EyePhoto& eye) {
  std::vector<OptionText> options = {{fs::path(a.input).filename().string(), {}},
                                     {"--mm-per-px", {text_of(eye.mm_per_px)}},
                                     {"--width-mm", {text_of(eye.pupil.width_mm)}},
                                     {"--size", {std::to_string(eye.pupil.transmittance.width())}}};
  const auto add = [&](const char* name, const std::vector<double>& numbers) {
    OptionText option{name, {}};
    for (const double number : numbers) option.values.push_back(text_of(number));
    if (!numbers.empty()) options.push_back(option);
  };
  add("--pupil-at", a.pupil_at);
  add("--lashes-region", a.region);
  add("--lashes-shift-mm", a.shift);
  if (a.flip) options.push_back({"--lashes-flip", {}});
  return aperture_recipe("photo", options);
}

std::vector<std::byte> bytes_of(const Output& output, const PhotoArguments& a, const EyePhoto& eye,
                                const RgbImage& photograph) {
  if (output.path == a.pupil_out) return encode_aperture_png(eye.pupil, recipe_of(a, eye));
  if (output.path == a.eyelashes_out) return encode_aperture_png(eye.eyelashes, recipe_of(a, eye));
  if (output.path == a.mask_out) return encode_png_gray8(eye.mask);
  return encode_png_rgb8(check_picture(photograph, eye));
}

/// All of them, or none: each is complete on the disk before the first gets its name.
void write_all(const std::vector<Output>& outputs) {
  const auto keep_going = [] { return !interrupted(); };
  std::vector<std::unique_ptr<AtomicFile>> files;
  for (const Output& output : outputs) {
    files.push_back(std::make_unique<AtomicFile>(output.path));
    files.back()->write_at(0, output.bytes);
    if (!keep_going()) throw Cancelled();
  }
  for (std::size_t i = 0; i < files.size(); ++i)
    files[i]->commit(i == 0 ? std::function<bool()>(keep_going) : std::function<bool()>());
}

EyePhoto found_eye(const PhotoArguments& a, const RgbImage& photograph) {
  try {
    return eye_from_photo(photograph, options_of(a));
  } catch (const InputError& error) {
    throw InputError(a.input, error.message());
  }
}

void run_photo(const PhotoArguments& a) {
  std::vector<Output> outputs = outputs_of(a);
  require_possible(outputs, a);
  const Photograph photograph = read_photograph(a.input, default_memory_limit_bytes());
  const Console console(a.quiet ? Verbosity::quiet : Verbosity::normal);
  for (const std::string& warning : photograph.warnings) console.warn(a.input + ": " + warning);
  const EyePhoto eye = found_eye(a, photograph.rgb);
  for (Output& output : outputs) output.bytes = bytes_of(output, a, eye, photograph.rgb);
  write_all(outputs);
  if (a.as_json)
    print(as_json(eye, a, photograph.rgb).dump(2, ' ', false, Json::error_handler_t::replace) +
          "\n");
}

void add_search_options(CLI::App& command, PhotoArguments& a) {
  command.add_option("--pupil-at", a.pupil_at, "A pixel within the pupil: X,Y")
      ->delimiter(',')
      ->expected(2)
      ->type_name("X,Y");
  command.add_option("--lashes-region", a.region, "Use only hairs in this part of the photograph")
      ->delimiter(',')
      ->expected(4)
      ->type_name("X,Y,W,H");
  command.add_flag("--lashes-flip", a.flip, "Turn the hairs over: what is above is then below");
  command
      .add_option("--lashes-shift-mm", a.shift,
                  "Move the hairs right and down, as when the lids narrow")
      ->delimiter(',')
      ->expected(2)
      ->type_name("DX,DY");
}

void add_scale_options(CLI::App& command, PhotoArguments& a) {
  auto* const iris = command.add_option("--iris-mm", a.iris_mm,
                                        "Scale: the iris' horizontal diameter (default 11.8)");
  auto* const pupil = command.add_option("--pupil-mm", a.pupil_mm, "Scale: the pupil's diameter");
  auto* const scale = command.add_option("--mm-per-px", a.mm_per_px, "Scale of the photograph");
  iris->excludes(pupil)->excludes(scale);
  pupil->excludes(scale);
  command.add_option("--width-mm", a.width_mm, "Width of the apertures, around the pupil's centre")
      ->capture_default_str();
  auto* const size =
      command.add_option("--size", a.size, "Their pixels, both ways")->capture_default_str();
  command.add_option("--pixel-um", a.pixel_um, "Their pixel's width instead")->excludes(size);
}

}  // namespace

Command add_aperture_photo_command(CLI::App& aperture) {
  CLI::App& command = *aperture.add_subcommand(
      "photo", "The pupil and the eyelashes from a close-up photograph, infrared or ordinary");
  const auto a = std::make_shared<PhotoArguments>();
  command.add_option("photo", a->input, "Picture with an eye in it")->required();
  command.add_option("--pupil-out", a->pupil_out, "16-bit PNG of the pupil, white = open");
  command.add_option("--eyelashes-out", a->eyelashes_out, "16-bit PNG of the eyelashes");
  command.add_option("--check", a->check, "PNG: what was found, drawn over the photograph");
  command.add_option("--mask-out", a->mask_out, "8-bit PNG: 255 within the pupil, as large as IN");
  command.add_flag("--json", a->as_json, "Tell where the pupil is, and how sure that is");
  command.add_flag("--quiet", a->quiet, "No warnings");
  add_search_options(command, *a);
  add_scale_options(command, *a);
  return [a] { run_photo(*a); };
}

}  // namespace glare::tool
