#include "glare/io/aperture_file.h"

#include <algorithm>
#include <cassert>
#include <cstdio>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/image/text_tags.h"
#include "glare/io/image_file.h"
#include "glare/io/openexr/aperture_exr.h"

namespace glare {

namespace {

Aperture read_one(const std::filesystem::path& path, const ApertureFiles& files,
                  std::vector<std::string>& warnings) {
  TransmittanceImage image = read_transmittance(path, files.memory_limit_bytes);
  for (const auto& warning : image.warnings) warnings.push_back(path.string() + ": " + warning);
  const std::optional<double> width_mm = files.width_mm ? files.width_mm : image.width_mm;
  if (!width_mm)
    throw OptionError("--width-mm is missing: the physical width of the aperture images, which " +
                      path.string() + " doesn't tell");
  Aperture aperture{std::move(image.transmittance), *width_mm};
  try {
    require_valid(aperture);
  } catch (const InputError& error) {
    throw InputError(path.string(), error.message());
  }
  return aperture;
}

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return ending;
}

/// As the attribute of an OpenEXR file has it.
std::string text_of_float(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(static_cast<float>(value)));
  return text;
}

}  // namespace

ApertureRead read_aperture(const ApertureFiles& files) {
  assert(!files.pupil.empty() || !files.eyelashes.empty());
  constexpr double kNarrowest_mm = 1e-3, kWidest_mm = 1e6;
  if (files.width_mm && !(*files.width_mm >= kNarrowest_mm && *files.width_mm <= kWidest_mm))
    throw OptionError("the aperture's width must be from 0.001 to 1000000 mm");
  ApertureRead result;
  if (files.pupil.empty() || files.eyelashes.empty()) {
    result.aperture =
        read_one(files.pupil.empty() ? files.eyelashes : files.pupil, files, result.warnings);
    return result;
  }
  result.aperture = stacked(read_one(files.pupil, files, result.warnings),
                            read_one(files.eyelashes, files, result.warnings));
  return result;
}

std::vector<std::byte> encode_aperture_png(const Aperture& aperture, const std::string& recipe) {
  std::vector<std::byte> png = encode_png_gray16(aperture.transmittance);
  png = image_io::png_with_text(png, "glare:software", "glare " GLARE_VERSION);
  png = image_io::png_with_text(png, "glare:recipe", recipe);
  return image_io::png_with_text(png, image_io::kWidthTag, text_of_float(aperture.width_mm));
}

void write_aperture(const std::filesystem::path& path, const Aperture& aperture,
                    const std::string& recipe, const std::function<bool()>& keep_going) {
  if (aperture.unlimited_energy_area_mm2)
    throw OptionError("a band-limited aperture isn't a picture of transmittances");
  const std::string ending = ending_of(path);
  if (ending == ".exr")
    openexr_io::write_aperture(path, aperture, recipe, keep_going);
  else if (ending == ".png")
    write_file_atomically(path, encode_aperture_png(aperture, recipe), keep_going);
  else
    throw OptionError(path.string() + ": expected a name that ends in .exr or .png");
}

}  // namespace glare
