// The way of an LM-63 file: the lines up to TILT= (version, keywords), the tilt, twelve or thirteen
// numbers about the luminaire, the angles, the intensities plane by plane, unfolding.
#include "glare/photometry/ies_text.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>
#include <vector>

#include "glare/base/error.h"
#include "glare/photometry/ies_header.h"
#include "glare/photometry/number_stream.h"
#include "glare/photometry/symmetry.h"
#include "glare/photometry/text_reading.h"

namespace glare {

using namespace photometry;

namespace {

constexpr int kMostAngles = 20'000;
constexpr double kLarge = 1e12;  // Of lumens, factors and watts: beyond anything real.

LampTilt tilt_from(NumberStream& numbers) {
  LampTilt tilt;
  tilt.lamp_to_luminaire_geometry = numbers.whole_number("the lamp-to-luminaire geometry", 1, 3);
  const int count = numbers.whole_number("the number of tilt angles", 1, kMostAngles);
  for (int i = 0; i < count; ++i) {
    tilt.angles_deg.push_back(numbers.number_within("a tilt angle", -360, 360));
    if (i > 0 && tilt.angles_deg.back() <= tilt.angles_deg[tilt.angles_deg.size() - 2])
      throw InputError(numbers.here(), "the tilt angles don't ascend");
  }
  for (int i = 0; i < count; ++i)
    tilt.multipliers.push_back(numbers.number_within("a tilt multiplier", 0, kLarge));
  return tilt;
}

/// Numbers may not be left over; text may.
void require_end(NumberStream& numbers, const std::string& place, const std::string& after,
                 std::vector<std::string>& warnings) {
  const NumberStream::Field left = numbers.next();
  if (left.text.empty()) return;
  if (finite_number_from(left.text))
    throw InputError(at_line(place, left.line),
                     quoted(left.text) + " is left over after " + after +
                         "; the counts of angles don't match what is there");
  warnings.push_back("line " + std::to_string(left.line) + ": " + quoted(left.text) +
                     " and what follows it, after " + after + ", is ignored");
}

std::optional<LampTilt> tilt_of_file(const IesHeader& header, const std::string& place,
                                     const IesOptions& options, NumberStream& numbers,
                                     std::vector<std::string>& warnings) {
  const std::string name = in_upper_case(header.tilt);
  if (name == "NONE") return std::nullopt;
  if (name == "INCLUDE") return tilt_from(numbers);
  if (name.empty()) {
    warnings.push_back("TILT= names nothing; it is taken as TILT=NONE");
    return std::nullopt;
  }
  const auto text = options.tilt_file ? options.tilt_file(header.tilt) : std::nullopt;
  if (!text) {
    warnings.push_back("the tilt file " + quoted(header.tilt) + " isn't read");
    return std::nullopt;
  }
  const std::string tilt_place = place + " (TILT " + readable(header.tilt) + ")";
  NumberStream tilt_numbers(Lines(*text), tilt_place);
  const LampTilt tilt = tilt_from(tilt_numbers);
  require_end(tilt_numbers, tilt_place, "the last tilt multiplier", warnings);
  return tilt;
}

struct Luminaire {
  int vertical_count = 0, horizontal_count = 0;
  PhotometricType type = PhotometricType::c;
};

/// A file's intensities, and where its horizontal angles are, for errors.
struct PlacedGrid {
  MeasuredGrid grid;
  std::string angles_place;
};

void note_lamps(NumberStream& numbers, PhotometricFileInfo& info) {
  info.lamp_count = numbers.whole_number("the number of lamps", 0, 1'000'000);
  const double lumens = numbers.number_within("the lumens per lamp", -kLarge, kLarge);
  info.absolute_photometry = lumens < 0;
  if (lumens > 0 && info.lamp_count > 0) info.lamp_flux_lm = info.lamp_count * lumens;
}

void note_size(NumberStream& numbers, PhotometricFileInfo& info) {
  const bool feet = numbers.whole_number("the units type (1 feet, 2 metres)", 1, 2) == 1;
  for (double& side : info.luminous_size_m)
    side = numbers.number_within("a luminous dimension", -1e6, 1e6) * (feet ? 0.3048 : 1);
}

void note_factors(NumberStream& numbers, int year, PhotometricFileInfo& info) {
  constexpr double least = 1e-12;
  info.intensity_factor *= numbers.number_within("the ballast factor", least, kLarge);
  const bool applies = year < 1995;
  const double other =
      numbers.number_within(applies ? "the ballast-lamp photometric factor"
                                    : "the number after the ballast factor (future use)",
                            applies ? least : -kLarge, kLarge);
  if (applies) info.intensity_factor *= other;
  if (!applies && year < 2019 && other != 1)
    info.warnings.push_back("the number for future use after the ballast factor is " +
                            text_of(other) + ", expected 1; it isn't applied");
  const double watts = numbers.number_within("the input watts", -kLarge, kLarge);
  if (watts > 0) info.input_watts = watts;
}

Luminaire luminaire_from(NumberStream& numbers, int year, PhotometricFileInfo& info) {
  Luminaire luminaire;
  note_lamps(numbers, info);
  info.intensity_factor = numbers.number_within("the candela multiplier", 1e-12, kLarge);
  luminaire.vertical_count = numbers.whole_number("the number of vertical angles", 2, kMostAngles);
  luminaire.horizontal_count =
      numbers.whole_number("the number of horizontal angles", 1, kMostAngles);
  const int type = numbers.whole_number("the photometric type (1 C, 2 B, 3 A)", 1, 3);
  luminaire.type = type == 1   ? PhotometricType::c
                   : type == 2 ? PhotometricType::b
                               : PhotometricType::a;
  if (luminaire.type != PhotometricType::c && luminaire.horizontal_count < 2)
    throw InputError(numbers.here(), "type A or B has one horizontal angle; expected two or more");
  note_size(numbers, info);
  note_factors(numbers, year, info);
  return luminaire;
}

std::vector<double> angles_from(NumberStream& numbers, int count, const std::string& name) {
  std::vector<double> angles_deg;
  for (int i = 0; i < count; ++i) {
    const double angle_deg = numbers.number(
        [&] { return name + " angle " + std::to_string(i + 1) + " of " + std::to_string(count); });
    if (i > 0 && angle_deg <= angles_deg.back())
      throw InputError(numbers.here(),
                       "the " + name + " angles don't ascend: " + text_of(angle_deg) + " follows " +
                           text_of(angles_deg.back()) + " (angle " + std::to_string(i + 1) +
                           " of " + std::to_string(count) + ")");
    if (std::abs(angle_deg) > 720)
      throw InputError(numbers.here(),
                       "the " + name + " angle " + text_of(angle_deg) + " isn't one in degrees");
    angles_deg.push_back(angle_deg);
  }
  return angles_deg;
}

/// The intensities of one horizontal angle; whether they begin on a line of their own.
bool read_plane(NumberStream& numbers, const PhotometricFileInfo& info, int plane,
                MeasuredGrid& grid) {
  bool on_own_line = false;
  const int count = grid.candela.height();
  for (int j = 0; j < count; ++j) {
    const auto what = [&] {
      return "the intensity " + std::to_string(j + 1) + " of " + std::to_string(count) +
             " at the horizontal angle " +
             text_of(grid.horizontal_deg[static_cast<std::size_t>(plane)]) + " (" +
             std::to_string(plane + 1) + " of " + std::to_string(grid.horizontal_deg.size()) + ")";
    };
    const double candela = numbers.number(what) * info.intensity_factor;
    if (j == 0) on_own_line = numbers.last().first_on_line;
    if (candela < 0 || candela > FLT_MAX)
      throw InputError(numbers.here(),
                       what() + " is " + text_of(candela) + " cd; expected 0 to 3e38");
    grid.candela(plane, j) = static_cast<float>(candela);
  }
  return on_own_line;
}

PlacedGrid grid_from(NumberStream& numbers, const Luminaire& luminaire, std::size_t text_size,
                     PhotometricFileInfo& info) {
  PlacedGrid placed;
  MeasuredGrid& grid = placed.grid;
  grid.vertical_deg = angles_from(numbers, luminaire.vertical_count, "vertical");
  grid.horizontal_deg = angles_from(numbers, luminaire.horizontal_count, "horizontal");
  if (luminaire.type == PhotometricType::c) snap_to_right_angles(grid.horizontal_deg);
  placed.angles_place = numbers.here();
  grid.candela = room_for_intensities(grid, text_size, placed.angles_place);
  bool in_rows = true, warned = false;
  for (int i = 0; i < luminaire.horizontal_count; ++i) {
    const bool on_own_line = read_plane(numbers, info, i, grid);
    if (i == 0) in_rows = on_own_line;
    if (in_rows && !on_own_line && !std::exchange(warned, true))
      info.warnings.push_back("line " + std::to_string(numbers.last().line) +
                              ": the intensities of horizontal angle " + std::to_string(i + 1) +
                              " don't begin on a line of their own; check that none before them "
                              "is missing or doubled");
  }
  return placed;
}

void note_uncommon_angles(PhotometricType type, const std::vector<double>& vertical_deg,
                          PhotometricFileInfo& info) {
  const double first = vertical_deg.front(), last = vertical_deg.back();
  const std::string range = text_of(first) + " to " + text_of(last);
  const bool c = type == PhotometricType::c;
  if (c && !((first == 0 || first == 90) && (last == 90 || last == 180)))
    info.warnings.push_back("the vertical angles go from " + range +
                            ", not 0 or 90 to 90 or 180; nothing is known beyond");
  if (!c && first == 0)
    info.warnings.push_back("the vertical angles go from " + range + "; nothing is known below 0");
}

/// The luminaire's flux, which laboratories write to a keyword of their own.
std::optional<double> stated_flux_lm(const IesHeader& header) {
  for (const auto& [name, value] : header.keywords)
    if (name == "_ABSOLUTELUMENS" || name == "_TOTALLUMENS")
      if (const auto lumens = finite_number_from(value); lumens && *lumens > 0) return lumens;
  return std::nullopt;
}

LuminousIntensityDistribution distribution_of(PhotometricType type, const MeasuredGrid& grid,
                                              const std::string& place,
                                              PhotometricFileInfo& info) try {
  const Unfolded whole =
      type == PhotometricType::c ? unfolded_type_c(grid) : unfolded_type_ab(grid);
  info.symmetry = whole.symmetry;
  if (whole.was_open)
    info.warnings.push_back("the horizontal angles go from " + text_of(grid.horizontal_deg[0]) +
                            " to " + text_of(grid.horizontal_deg.back()) +
                            "; the circle is closed with the first plane");
  return distribution_from(type, whole.grid, place);
} catch (const InputError& error) {
  throw InputError(place, error.message());
}

}  // namespace

bool looks_like_ies(std::string_view text) {
  Lines lines(text);
  while (const auto line = lines.next())
    if (tilt_value(*line)) return true;
  return false;
}

PhotometricData parse_ies(std::string_view text, const std::string& place,
                          const IesOptions& options) {
  PhotometricFileInfo info;
  info.format = "IES LM-63";
  Lines lines(text);
  IesHeader header = ies_header_from(lines, place, info.warnings);
  NumberStream numbers(lines, place);
  info.version = header.version;
  info.tilt = tilt_of_file(header, place, options, numbers, info.warnings);
  info.stated_flux_lm = stated_flux_lm(header);
  info.keywords = std::move(header.keywords);
  const Luminaire luminaire = luminaire_from(numbers, header.year, info);
  const auto [grid, angles_place] = grid_from(numbers, luminaire, text.size(), info);
  require_end(numbers, place, "the last intensity", info.warnings);
  note_uncommon_angles(luminaire.type, grid.vertical_deg, info);
  auto distribution = distribution_of(luminaire.type, grid, angles_place, info);
  return {std::move(distribution), std::move(info)};
}

}  // namespace glare
