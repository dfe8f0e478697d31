#include "glare/io/photometry_file.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"
#include "glare/io/image/decoder.h"
#include "glare/io/image/intensities.h"
#include "glare/io/openexr/intensity_exr.h"
#include "glare/photometry/eulumdat_text.h"
#include "glare/photometry/ies_text.h"
#include "glare/photometry/text_reading.h"

namespace glare {

using image_io::BadImage;
using image_io::Bytes;
using image_io::Intensities;

namespace {

constexpr std::uint64_t kLargestText_bytes = 64'000'000, kLargestTilt_bytes = 1'000'000;

bool is_plain_name(const std::string& name) {
  return !name.empty() && name != "." && name != ".." &&
         name.find_first_of(std::string_view("/\\:\0", 4)) == std::string::npos;
}

/// The tilt file beside the file at `path`.
std::optional<std::string> tilt_text(const std::filesystem::path& path, const std::string& name) {
  if (!is_plain_name(name)) return std::nullopt;
  const std::filesystem::path tilt_path = path.parent_path() / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(tilt_path, error)) return std::nullopt;
  const Bytes bytes = read_file(tilt_path, kLargestTilt_bytes);
  return std::string(image_io::text_of(bytes));
}

enum class Kind { ies, eulumdat, image, unknown };

Kind kind_of(const std::filesystem::path& path, const Bytes& bytes) {
  const std::string_view text = image_io::text_of(bytes);
  const std::string ending = photometry::in_upper_case(path.extension().string());
  if (text.find('\0') == std::string_view::npos) {
    const bool ies = looks_like_ies(text), eulumdat = looks_like_eulumdat(text);
    if (ies && !(eulumdat && ending == ".LDT")) return Kind::ies;
    if (eulumdat) return Kind::eulumdat;
  }
  if (image_io::is_picture(bytes)) return Kind::image;
  if (ending == ".IES") return Kind::ies;
  if (ending == ".LDT") return Kind::eulumdat;
  return Kind::unknown;
}

void require_image_options(const ReadPhotometryOptions& options) {
  const auto white = options.image_white_cd;
  if (white && !(*white > 0 && *white <= 1e12))
    throw OptionError("the candela of an image's white is " + photometry::text_of(*white) +
                      "; expected a positive number up to 1e12");
}

PhotometricData data_from(Intensities image, const ReadPhotometryOptions& options,
                          const std::string& place) {
  const auto h_deg = options.image_h_deg ? options.image_h_deg : image.horizontal_range_deg;
  const auto v_deg = options.image_v_deg ? options.image_v_deg : image.vertical_range_deg;
  if (!h_deg || !v_deg)
    throw OptionError(place +
                      " is an image, which needs the degrees of its first and last column and row");
  PhotometricFileInfo info;
  info.format = "image";
  info.absolute_photometry = true;
  info.intensity_factor = options.image_white_cd.value_or(1);
  info.warnings = std::move(image.warnings);
  if (!options.image_white_cd && image.has_whole_numbers)
    throw InputError(place, "a picture of whole numbers needs the candela of its white");
  for (float& value : image.values.values())
    value = static_cast<float>(value * info.intensity_factor);
  const IntensityGrid grid{*h_deg, *v_deg, image.values.width(), image.values.height()};
  return {distribution_from_image(image.values, grid), std::move(info)};
}

PhotometricData image_data(Bytes bytes, const ReadPhotometryOptions& options,
                           const std::string& place) {
  require_image_options(options);
  try {
    return data_from(image_io::intensities_of(std::move(bytes), options.memory_limit_bytes),
                     options, place);
  } catch (const BadImage& bad) {
    throw InputError(place, bad.what());
  } catch (const InputError& error) {
    throw InputError(place, error.message());
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw MemoryError(options.memory_limit_bytes, options.memory_limit_bytes);
  } catch (const std::exception& error) {
    throw InputError(place, "the data are damaged: " + image_io::one_line(error.what()));
  }
}

void require_text(std::string_view text, const std::string& place) {
  if (text.size() > kLargestText_bytes)
    throw InputError(place, "is larger than 64 MB, too large for a photometric file");
  if (text.find('\0') != std::string_view::npos)
    throw InputError(place, "is no text, as IES LM-63 and EULUMDAT files are");
}

}  // namespace

PhotometricData read_photometry(const std::filesystem::path& path,
                                const ReadPhotometryOptions& options) {
  const std::string place = path.string();
  Bytes bytes = read_file(path, std::max(options.memory_limit_bytes, kLargestText_bytes));
  const Kind kind = kind_of(path, bytes);
  if (kind == Kind::image) return image_data(std::move(bytes), options, place);
  if (options.image_h_deg || options.image_v_deg || options.image_white_cd)
    throw OptionError(place + " is no image, but the degrees or the white of one are given");
  const std::string_view text = image_io::text_of(bytes);
  if (kind == Kind::unknown)
    throw InputError(place,
                     "is neither an IES LM-63 file (no line TILT=), nor EULUMDAT, nor an image");
  require_text(text, place);
  if (kind == Kind::eulumdat) return parse_eulumdat(text, place, {options.lamp_set});
  return parse_ies(text, place, {[&](const std::string& name) { return tilt_text(path, name); }});
}

void write_intensity_image(const std::filesystem::path& path,
                           const LuminousIntensityDistribution& distribution,
                           const IntensityGrid& grid, const Mounting& mounting, int threads,
                           const ProgressCallback& progress) {
  const Image<float> candela =
      image_from_distribution(on_grid(distribution, grid, mounting, threads, progress));
  openexr_io::write_intensities(path, candela, grid, [&] { return !progress || progress(1); });
}

}  // namespace glare
