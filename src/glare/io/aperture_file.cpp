#include "glare/io/aperture_file.h"

#include <cassert>

#include "glare/base/error.h"
#include "glare/io/image_file.h"

namespace glare {

namespace {

Aperture read_one(const std::filesystem::path& path, const ApertureFiles& files,
                  std::vector<std::string>& warnings) {
  TransmittanceImage image = read_transmittance(path, files.memory_limit_bytes);
  for (const auto& warning : image.warnings) warnings.push_back(path.string() + ": " + warning);
  Aperture aperture{std::move(image.transmittance), files.width_mm};
  try {
    require_valid(aperture);
  } catch (const InputError& error) {
    throw InputError(path.string(), error.message());
  }
  return aperture;
}

}  // namespace

ApertureRead read_aperture(const ApertureFiles& files) {
  assert(!files.pupil.empty() || !files.eyelashes.empty());
  constexpr double kNarrowest_mm = 1e-3, kWidest_mm = 1e6;
  if (!(files.width_mm >= kNarrowest_mm && files.width_mm <= kWidest_mm))
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

}  // namespace glare
