// Apertures from a photograph of an eye: its pupil's outline and the hairs in front of it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "glare/aperture/aperture.h"
#include "glare/base/image.h"

namespace glare {

/// A colour picture; grey ones have three equal values.
using RgbImage = Image<std::array<float, 3>>;

struct Photograph {
  RgbImage rgb;                       ///< Each value in [0, 1], as stored: encoded for a display.
  std::vector<std::string> warnings;  ///< One line each, without the file's name.
};

/// The photograph in the file at `path`: any picture that `read_transmittance` reads, with the same
/// errors. Floats above 1 are allowed; the picture is then divided by the largest.
Photograph read_photograph(const std::filesystem::path& path, std::uint64_t max_bytes);

struct PixelRectangle {
  double x = 0, y = 0, width = 0, height = 0;
};

struct EyePhotoOptions {
  /// A pixel within the pupil, where the search is to be steered.
  std::optional<std::array<double, 2>> pupil_at_px;
  /// Only hairs in here are used; without it those of the whole photograph.
  std::optional<PixelRectangle> lashes_region_px;
  bool flip_lashes = false;  ///< Turn them over within the region: what is above is then below.
  std::array<double, 2> lashes_shift_mm = {0, 0};  ///< Then move them right and down.

  /// What gives the scale: at most one of the last two, and otherwise the iris.
  double iris_mm = 11.8;           ///< Horizontal visible diameter of the iris.
  std::optional<double> pupil_mm;  ///< Geometric mean of the pupil's axes.
  std::optional<double> mm_per_px;

  double width_mm = 8;  ///< Of the square apertures, whose middle is the pupil's ellipse's centre.
  int size = 2048;      ///< Their pixels, both ways, 16 to 16384.
  std::uint64_t memory_limit_bytes = UINT64_MAX;
};

/// Places are in pixels of the photograph, from the centre of its top left pixel right and down.
struct EyePhoto {
  std::array<double, 2> pupil_center_px{};  ///< Of the ellipse that its true edge lies on.
  std::array<double, 2> pupil_axes_px{};    ///< Full lengths, the major one first.
  double pupil_angle_deg = 0;  ///< Of the major axis, from the x axis towards y, -90 to 90.
  double confidence = 0;       ///< 0 to 1.
  std::vector<std::array<double, 2>> outline_px;  ///< The pupil's own, as far as it is seen.

  std::array<double, 2> iris_center_px{};
  double iris_diameter_px = 0;  ///< 0 where the limbus isn't seen.
  double iris_confidence = 0;   ///< 0 to 1.

  double mm_per_px = 0;
  Image<std::uint8_t> mask;  ///< The photograph's pixels: 255 within the outline, else 0.
  Image<float> hairs;        ///< The photograph's pixels: transmittance of the hairs found there.

  Aperture pupil;      ///< The outline, drawn by area.
  Aperture eyelashes;  ///< The hairs, turned over and moved as asked for, enlarged smoothly.

  /// Geometric mean of the axes.
  double pupil_diameter_mm() const;
};

/// The eye in a photograph: an infrared or ordinary close-up, 96 x 96 to 16384 x 16384 pixels.
///
/// The pupil is looked for as the circle across which the picture brightens most evenly
/// (Daugman 1993), then as the ellipse that most of its edge agrees on (Fischler and Bolles 1981);
/// glints are left out. How sure it is follows from the edge's support, roundness and contrast, and
/// from the limbus around it.
///
/// Throws `InputError` where there is no pupil or nothing gives the scale, `OptionError` for
/// options outside their ranges, `MemoryError`, and `Error` where the module glare_eye_photo can't
/// be loaded or OpenCV fails.
EyePhoto eye_from_photo(const RgbImage& photograph, const EyePhotoOptions& options);

/// The photograph in grey with the pupil's outline in green, its ellipse in yellow where the two
/// differ, the limbus in blue and the hairs in red; the mm scale's window as a white frame.
RgbImage check_picture(const RgbImage& photograph, const EyePhoto& eye);

}  // namespace glare
