// What a photometric file says: a lamp's luminous intensity, and what is told beside it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "glare/photometry/luminous_intensity.h"

namespace glare {

/// How a file's angles stand for those that it leaves out. The distribution itself is unfolded.
enum class PhotometricSymmetry {
  none,          ///< All angles are there.
  rotational,    ///< One plane for all C.
  plane_0_180,   ///< C to 360 - C.
  plane_90_270,  ///< C to 180 - C.
  quadrants,     ///< Both of these.
  lateral        ///< Of type A and B: H to -H.
};

/// "none", "rotational", "C0-C180", "C90-C270", "quadrants" or "lateral".
std::string name_of(PhotometricSymmetry symmetry);

/// How a lamp's flux depends on the luminaire's tilt (LM-63 TILT). Told for those who tilt a
/// luminaire; it changes no intensity here.
struct LampTilt {
  int lamp_to_luminaire_geometry = 1;  ///< 1 to 3.
  std::vector<double> angles_deg;      ///< Ascending.
  std::vector<double> multipliers;
};

struct PhotometricFileInfo {
  std::string format;   ///< "IES LM-63", "EULUMDAT" or "image".
  std::string version;  ///< The version line of LM-63, "" where there is none (1986).
  PhotometricSymmetry symmetry = PhotometricSymmetry::none;  ///< As in the file.
  int lamp_count = 0;
  /// Of all lamps together, in lumen; nothing in absolute photometry and where it isn't told.
  std::optional<double> lamp_flux_lm;
  bool absolute_photometry = false;  ///< The intensities don't depend on a lamp's rated flux.
  /// The luminaire's flux as the file tells it; to compare with `luminous_flux_lm`.
  std::optional<double> stated_flux_lm;
  double intensity_factor = 1;  ///< By which the file's numbers were multiplied to be candela.
  std::optional<double> input_watts;
  /// Of the luminous opening, in metres: along C 90, along C 0, and its height. (LM-63's width and
  /// length; EULUMDAT's length and width.) In LM-63 negative numbers mean round shapes.
  std::array<double, 3> luminous_size_m{};
  std::optional<LampTilt> tilt;
  /// Name and text, in the order of the file; UTF-8. Names are in capitals, without brackets; label
  /// lines of LM-63-1986 have none. [MORE] lines are joined to what they go on with.
  std::vector<std::pair<std::string, std::string>> keywords;
  std::vector<std::string> warnings;  ///< One line each, without the file's name.
};

struct PhotometricData {
  LuminousIntensityDistribution distribution;
  PhotometricFileInfo info;
};

}  // namespace glare
