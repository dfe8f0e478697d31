#include "glare/photometry/eulumdat_text.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>
#include <vector>

#include "glare/base/error.h"
#include "glare/photometry/line_fields.h"
#include "glare/photometry/symmetry.h"
#include "glare/photometry/text_reading.h"

namespace glare {

using namespace photometry;

namespace {

constexpr int kMostAngles = 20'000, kMostLampSets = 100;
constexpr double kLarge = 1e12;

struct Counts {
  int symmetry = 0;
  int planes = 0, intensities = 0;  ///< Mc and Ng.
  double plane_step_deg = 0, gamma_step_deg = 0;
};

Counts counts_from(LineFields& fields) {
  Counts counts;
  fields.whole_number("the type indicator", 0, 3);
  counts.symmetry = fields.whole_number("the symmetry indicator", 0, 4);
  counts.planes = fields.whole_number("the number of C-planes", 1, kMostAngles);
  counts.plane_step_deg = fields.optional_number("the step between C-planes");
  counts.intensities =
      fields.whole_number("the number of intensities in each C-plane", 2, kMostAngles);
  counts.gamma_step_deg = fields.optional_number("the step between intensities");
  return counts;
}

void note_text(LineFields& fields, const char* name, const char* what, PhotometricFileInfo& info) {
  const std::string text = fields.text(what);
  if (!text.empty()) info.keywords.emplace_back(name, text);
}

void note_names(LineFields& fields, PhotometricFileInfo& info) {
  note_text(fields, "TEST", "the number of the measurement's report", info);
  note_text(fields, "LUMINAIRE", "the luminaire's name", info);
  note_text(fields, "LUMCAT", "the luminaire's number", info);
  note_text(fields, "FILENAME", "the file's name", info);
  note_text(fields, "ISSUEDATE", "the date", info);
}

void note_sizes(LineFields& fields, PhotometricFileInfo& info) {
  for (int i = 0; i < 3; ++i) fields.optional_number("a size of the luminaire");
  const double length_mm = fields.optional_number("the length of the luminous area");
  const double width_mm = fields.optional_number("the width of the luminous area");
  const double height_mm = fields.optional_number("a height of the luminous area");
  for (int i = 0; i < 3; ++i) fields.optional_number("a height of the luminous area");
  info.luminous_size_m = {length_mm / 1000, width_mm / 1000, height_mm / 1000};
}

struct Ratios {
  double light_output_percent = 0;
  double conversion_factor = 1;
};

Ratios ratios_from(LineFields& fields, PhotometricFileInfo& info) {
  Ratios ratios;
  fields.optional_number("the downward flux fraction");
  ratios.light_output_percent = fields.optional_number("the light output ratio");
  ratios.conversion_factor = fields.number("the conversion factor of intensities", 0, kLarge);
  if (ratios.conversion_factor == 0) {
    ratios.conversion_factor = 1;
    info.warnings.push_back("the conversion factor of intensities is 0; it is taken as 1");
  }
  fields.optional_number("the tilt during measurement");
  return ratios;
}

struct LampSet {
  int count = 0;
  std::string type;
  double flux_lm = 0;
  double watts = 0;
};

LampSet lamp_set_from(LineFields& fields, bool is_taken) {
  LampSet set;
  set.count = fields.whole_number("the number of lamps", -1'000'000, 1'000'000);
  set.type = fields.text("the type of lamps");
  set.flux_lm = fields.number("the total flux of the lamps", is_taken ? 1e-9 : 0, kLarge);
  fields.text("the colour of the lamps");
  fields.text("the colour rendering of the lamps");
  set.watts = fields.optional_number("the watts of the lamps");
  return set;
}

/// Reads all sets; the one that counts.
LampSet taken_lamp_set(LineFields& fields, const EulumdatOptions& options, const std::string& place,
                       PhotometricFileInfo& info) {
  const int count = fields.whole_number("the number of sets of lamps", 1, kMostLampSets);
  const int wanted = options.lamp_set.value_or(1);
  if (wanted < 1 || wanted > count)
    throw OptionError("set of lamps " + std::to_string(wanted) + " isn't in " + place +
                      ", which has " + std::to_string(count));
  LampSet taken;
  for (int i = 1; i <= count; ++i) {
    const LampSet set = lamp_set_from(fields, i == wanted);
    if (i == wanted) taken = set;
  }
  if (count > 1 && !options.lamp_set)
    info.warnings.push_back("there are " + std::to_string(count) +
                            " sets of lamps; the first one is taken, of " + text_of(taken.flux_lm) +
                            " lm");
  return taken;
}

void note_lamps(const LampSet& lamps, const Ratios& ratios, PhotometricFileInfo& info) {
  info.lamp_count = std::abs(lamps.count);
  info.absolute_photometry = lamps.count < 0;
  if (!info.absolute_photometry) info.lamp_flux_lm = lamps.flux_lm;
  if (ratios.light_output_percent > 0)
    info.stated_flux_lm = lamps.flux_lm * ratios.light_output_percent / 100;
  if (lamps.watts > 0) info.input_watts = lamps.watts;
  if (!lamps.type.empty()) info.keywords.emplace_back("LAMP", lamps.type);
  info.intensity_factor = ratios.conversion_factor * lamps.flux_lm / 1000;
}

void note_steps(const std::vector<double>& angles_deg, double step_deg, const char* what,
                PhotometricFileInfo& info) {
  if (step_deg <= 0) return;
  for (std::size_t i = 0; i < angles_deg.size(); ++i) {
    const double expected_deg = angles_deg.front() + static_cast<double>(i) * step_deg;
    if (same_angle(angles_deg[i], expected_deg)) continue;
    info.warnings.push_back(std::string("the ") + what + " angles aren't in the steps of " +
                            text_of(step_deg) + " degrees that the file tells: there is " +
                            text_of(angles_deg[i]) + " instead of " + text_of(expected_deg) +
                            "; the angles are taken as they are");
    return;
  }
}

/// Which plane is at an angle. Throws where there is none.
int plane_at(const std::vector<double>& planes_deg, double angle_deg, const std::string& place) {
  for (std::size_t i = 0; i < planes_deg.size(); ++i)
    if (same_angle(planes_deg[i], angle_deg)) return static_cast<int>(i);
  throw InputError(place,
                   "there is no plane C " + text_of(angle_deg) + ", as the file's symmetry needs");
}

/// The angles of the planes whose intensities are in the file, ascending: all of them; the first
/// one; 0 to 180; 270 to 360 + 90, as -90 to 90; 0 to 90. Throws where the planes aren't as many as
/// EULUMDAT's Mc1 to Mc2.
std::vector<double> stored_planes_deg(const Counts& counts, const std::vector<double>& planes_deg,
                                      const std::string& place) {
  if (counts.symmetry == 0) return planes_deg;
  if (counts.symmetry == 1) return {planes_deg.front()};
  const auto begin = planes_deg.begin();
  const int last = plane_at(planes_deg, counts.symmetry == 2 ? 180 : 90, place);
  std::vector<double> stored_deg;
  if (counts.symmetry == 3)
    for (auto angle = begin + plane_at(planes_deg, 270, place); angle != planes_deg.end(); ++angle)
      stored_deg.push_back(*angle - 360);
  else
    plane_at({planes_deg.front()}, 0, place);  // Throws where the first one isn't there.
  stored_deg.insert(stored_deg.end(), begin, begin + last + 1);
  const int expected = counts.planes / (counts.symmetry == 4 ? 4 : 2) + 1;
  if (static_cast<int>(stored_deg.size()) != expected)
    throw InputError(place, "there are " + std::to_string(stored_deg.size()) +
                                " C-planes in the part that symmetry " +
                                std::to_string(counts.symmetry) + " stores; expected " +
                                std::to_string(expected) + " of " + std::to_string(counts.planes));
  return stored_deg;
}

void read_intensities(LineFields& fields, double factor, MeasuredGrid& grid) {
  for (int i = 0; i < grid.candela.width(); ++i)
    for (int j = 0; j < grid.candela.height(); ++j) {
      const double candela = fields.number("an intensity", 0, kLarge) * factor;
      if (candela > FLT_MAX) throw InputError(fields.here(), "the intensity is absurdly large");
      grid.candela(i, j) = static_cast<float>(candela);
    }
}

MeasuredGrid unfolded(const MeasuredGrid& grid, int symmetry, PhotometricFileInfo& info) {
  using enum PhotometricSymmetry;
  constexpr PhotometricSymmetry kSymmetries[] = {none, rotational, plane_0_180, plane_90_270,
                                                 quadrants};
  info.symmetry = kSymmetries[symmetry];
  switch (symmetry) {
    case 1:
      return around_the_axis(grid);
    case 2:
    case 3:
      return from_zero(mirrored_about_last(grid));
    case 4:
      return mirrored_about_last(mirrored_about_last(grid));
    default:
      if (grid.horizontal_deg.size() > 1)
        return from_zero(is_closed(grid) ? grid : closed_circle(grid));
      info.symmetry = rotational;
      info.warnings.push_back(
          "there is one C-plane, though the file tells no symmetry; it is taken "
          "for all C");
      return around_the_axis(grid);
  }
}

MeasuredGrid grid_from(LineFields& fields, const Counts& counts, std::size_t text_size,
                       PhotometricFileInfo& info) {
  auto planes_deg = fields.angles_deg("the angle of a C-plane", counts.planes, 360);
  snap_to_right_angles(planes_deg);
  const std::string planes_place = fields.here();
  MeasuredGrid grid;
  grid.vertical_deg = fields.angles_deg("the angle of an intensity", counts.intensities, 180);
  grid.horizontal_deg = stored_planes_deg(counts, planes_deg, planes_place);
  note_steps(planes_deg, counts.symmetry == 1 ? 0 : counts.plane_step_deg, "C", info);
  note_steps(grid.vertical_deg, counts.gamma_step_deg, "gamma", info);
  grid.candela = room_for_intensities(grid, text_size, fields.here());
  read_intensities(fields, info.intensity_factor, grid);
  fields.require_end(info.warnings);
  return unfolded(grid, counts.symmetry, info);
}

}  // namespace

bool looks_like_eulumdat(std::string_view text) {
  Lines lines(text);
  for (int line_number = 1; line_number <= 26; ++line_number) {
    const auto line = lines.next();
    if (!line) return false;
    const auto number = finite_number_from(trimmed(*line), true);
    const bool whole = number && *number == std::floor(*number);
    if (line_number == 2 && !(whole && *number >= 0 && *number <= 3)) return false;
    if (line_number == 3 && !(whole && *number >= 0 && *number <= 4)) return false;
    if ((line_number == 4 || line_number == 6) && !(whole && *number >= 1)) return false;
    const bool may_be_empty = line_number == 5 || line_number == 7;
    if (may_be_empty && !trimmed(*line).empty() && !(number && *number >= 0)) return false;
  }
  return true;
}

PhotometricData parse_eulumdat(std::string_view text, const std::string& place,
                               const EulumdatOptions& options) {
  PhotometricFileInfo info;
  info.format = "EULUMDAT";
  LineFields fields(text, place);
  note_text(fields, "MANUFAC", "the company's name", info);
  const Counts counts = counts_from(fields);
  note_names(fields, info);
  note_sizes(fields, info);
  const Ratios ratios = ratios_from(fields, info);
  note_lamps(taken_lamp_set(fields, options, place, info), ratios, info);
  for (int i = 0; i < 10; ++i) fields.optional_number("a direct ratio");
  const MeasuredGrid grid = grid_from(fields, counts, text.size(), info);
  return {distribution_from(PhotometricType::c, grid, place), std::move(info)};
}

}  // namespace glare
