// Rows about the error against the exact reference.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "eye_template.h"
#include "glare/glare.h"
#include "rows.h"
#include "support/bins_pitch_case.h"
#include "support/exact_pixels.h"
#include "support/lamps.h"
#include "support/pixel_errors.h"

namespace glare::bench {

namespace {

constexpr int kPixels = 3000, kOuterPixels = 1500;

struct NamedLamp {
  std::string name;
  Spectrum spectrum;
};

std::vector<NamedLamp> lamps() {
  return {{"HP5", *find_lamp("HP5")},
          {"FL11", *find_lamp("FL11")},
          {"narrow lines", test::lamp_with_narrow_lines()}};
}

const ColorMatchingFunctions& observer() { return color_matching_functions("cie1931-2deg"); }

/// Largest of the lamps' 99th percentiles, and all of them as text.
struct Worst {
  double luminance_percent = 0, delta_e = 0;
  std::string luminance_text, delta_e_text;
};

void take(double value, const std::string& lamp, double& worst, std::string& text) {
  char part[80];
  std::snprintf(part, sizeof part, "%s%s %.3g", text.empty() ? "" : ", ", lamp.c_str(), value);
  text += part;
  worst = std::max(worst, value);
}

/// XYZ per steradian of a lamp's template.
using Picture = std::function<XyzImage(const Spectrum& lamp)>;

/// What a reference of these pixels was summed over.
std::string reference_text(const exact::PixelRequest& request, const Aperture& aperture,
                           const exact::PixelResult& reference, const std::string& where) {
  char text[240];
  std::snprintf(text, sizeof text,
                "; %zu pixels %s; aperture %d² samples; reference of %d to %d wavelengths",
                request.pixels.size(), where.c_str(), aperture.transmittance.width(),
                reference.fewest_wavelengths, reference.most_wavelengths);
  return text;
}

Worst worst_of_lamps(const std::vector<NamedLamp>& lamps, const Aperture& aperture,
                     const exact::PixelRequest& request, const Picture& picture,
                     const std::string& where) {
  std::vector<exact::SpectralTable> tables;
  for (const NamedLamp& lamp : lamps) tables.push_back(test::table_of(lamp.spectrum));
  const auto reference = exact::xyz_at(aperture, request, test::tables_of(observer()), tables);
  Worst out;
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const test::PixelErrors errors(picture(lamps[i].spectrum), request.pixels, reference.xyz[i]);
    take(100 * test::percentile(errors.luminance, 0.99), lamps[i].name, out.luminance_percent,
         out.luminance_text);
    take(test::percentile(errors.delta_e, 0.99), lamps[i].name, out.delta_e, out.delta_e_text);
  }
  out.luminance_text += reference_text(request, aperture, reference, where);
  return out;
}

constexpr const char* kEverywhere = "over log radius and angle, all counted";

std::vector<exact::Pixel> pixels_everywhere(int size) {
  return exact::spread_pixels(size, size, kPixels, 0.5, size * std::sqrt(0.5));
}

Worst at_bins_pitch(int size, const std::vector<exact::Pixel>& pixels, const std::string& where) {
  const test::BinsPitchCase c(size, size);
  const FarField field = c.field(0);
  const auto picture = [&](const Spectrum& lamp) {
    return spectral_integral(field, c.grid, lamp, observer(), c.range, 0, {});
  };
  return worst_of_lamps(lamps(), c.aperture, c.request(pixels), picture, where);
}

const Worst& over_all_radii(int size) {
  static std::map<int, Worst> known;
  if (const auto found = known.find(size); found != known.end()) return found->second;
  return known.emplace(size, at_bins_pitch(size, pixels_everywhere(size), kEverywhere))
      .first->second;
}

Worst over_outer_quarter(int size) {
  const auto pixels =
      exact::spread_pixels(size, size, kOuterPixels, size * 3. / 8, size * std::sqrt(0.5));
  return at_bins_pitch(size, pixels, "from 3/4 of the half width to the corners");
}

/// Of the template of which make_template's time is told.
Worst eye_template_error(int size) {
  const Aperture aperture = eight_millimetre_eye(size);
  const TemplateOptions options = eye_template_options(size);
  const PixelGrid grid = pixel_grid(options);
  const std::vector<NamedLamp> only = {{"HP5", *find_lamp("HP5")}};
  const WavelengthRange range = effective_range(only[0].spectrum, options);
  const auto picture = [&](const Spectrum& lamp) {
    return make_template(aperture, lamp, options).channels;
  };
  return worst_of_lamps(
      only, aperture,
      {size, size, grid.pitch_rad, pixels_everywhere(size), range.lo_nm, range.hi_nm}, picture,
      kEverywhere);
}

void add_size(Rows& rows, Scale scaled, int full_size, bool slow) {
  const int size = scaled(full_size);
  const std::string name = std::to_string(full_size);
  rows.add(
      {"accuracy, " + name + "²: luminance, 99th percentile, worst of three lamps", "%", 1, 0.3},
      {"accuracy/luminance/" + name, 1, slow, false, [=](Measurement& m) {
         m.add(over_all_radii(size).luminance_percent);
         m.set_remark(over_all_radii(size).luminance_text);
       }});
  rows.add({"accuracy, " + name + "²: CIEDE2000, 99th percentile, worst of three lamps", "ΔE₀₀",
            0.5, 0.2},
           {"accuracy/color/" + name, 1, slow, false, [=](Measurement& m) {
              m.add(over_all_radii(size).delta_e);
              m.set_remark(over_all_radii(size).delta_e_text);
            }});
}

}  // namespace

void add_accuracy_rows(Rows& rows, Scale scaled) {
  const int eye_size = scaled(1024);
  rows.add({"accuracy of the `make_template` above: luminance, 99th percentile", "%", 1, 0.3},
           {"accuracy/template", 1, false, false, [=](Measurement& m) {
              const Worst worst = eye_template_error(eye_size);
              m.add(worst.luminance_percent);
              m.set_remark(worst.luminance_text + "; CIEDE2000 " + worst.delta_e_text);
            }});
  add_size(rows, scaled, 1024, false);
  add_size(rows, scaled, 4096, true);
  const int size = scaled(4096);
  rows.add({"no bands: 4096², the outer quarter, luminance, 99th percentile, worst of three lamps",
            "%", 1, 0.3},
           {"accuracy/outer_quarter", 1, true, false, [=](Measurement& m) {
              const Worst worst = over_outer_quarter(size);
              m.add(worst.luminance_percent);
              m.set_remark(worst.luminance_text);
            }});
}

}  // namespace glare::bench
