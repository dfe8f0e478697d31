// glare photometry info: what a photometric file holds.

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "console.h"
#include "glare/base/range_check.h"
#include "glare/io/atomic_file.h"
#include "glare/photometry/beam.h"
#include "info_text.h"
#include "interruption.h"
#include "photometry/photometry_arguments.h"
#include "photometry/photometry_plot.h"
#include "svg.h"

namespace glare::tool {

namespace {

using Json = nlohmann::ordered_json;

struct PhotometryInfoArguments {
  PhotometryInput input;
  std::vector<std::pair<double, double>> at;
  bool as_json = false;
  std::string plot;
  PlotRange plot_range;
};

struct Intensity {
  double horizontal_deg = 0, vertical_deg = 0, candela = 0;
};

/// Everything there is to say of a file.
struct Photometry {
  std::string file;
  PhotometricData data;
  double flux_lm = 0;
  PeakIntensity peak;
  BeamWidths half, tenth;
  std::vector<Intensity> at;
};

Photometry photometry_of(const PhotometryInfoArguments& a) {
  Photometry p{a.input.file, photometry_from(a.input), 0, {}, {}, {}, {}};
  const LuminousIntensityDistribution& distribution = p.data.distribution;
  p.flux_lm = luminous_flux_lm(distribution);
  p.peak = peak_intensity(distribution);
  p.half = beam_widths(distribution, 0.5);
  p.tenth = beam_widths(distribution, 0.1);
  for (const auto& [h, v] : a.at) p.at.push_back({h, v, distribution(h, v)});
  return p;
}

const char* letter_of(PhotometricType type) {
  return type == PhotometricType::a ? "A" : type == PhotometricType::b ? "B" : "C";
}

/// What the two angles are called.
std::array<std::string, 2> angle_names(PhotometricType type) {
  if (type == PhotometricType::c) return {"C", "gamma"};
  return {"H", "V"};
}

/// The luminaire's flux as a share of its lamps'.
std::optional<double> light_output_ratio(const Photometry& p) {
  const auto& lamps = p.data.info.lamp_flux_lm;
  if (!lamps || *lamps <= 0) return std::nullopt;
  return p.flux_lm / *lamps;
}

// As JSON.

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json angles_as_json(const std::vector<double>& angles) {
  return {{"count", angles.size()}, {"first", angles.front()}, {"last", angles.back()}};
}

Json widths_as_json(const BeamWidths& widths) {
  return {or_null(widths.horizontal_deg), or_null(widths.vertical_deg)};
}

Json keywords_as_json(const PhotometricFileInfo& info) {
  Json keywords = Json::array();
  for (const auto& [name, text] : info.keywords)
    keywords.push_back({{"name", name}, {"text", text}});
  return keywords;
}

Json tilt_as_json(const PhotometricFileInfo& info) {
  if (!info.tilt) return nullptr;
  return {{"lamp_to_luminaire_geometry", info.tilt->lamp_to_luminaire_geometry},
          {"angles_deg", info.tilt->angles_deg},
          {"multipliers", info.tilt->multipliers}};
}

Json at_as_json(const Photometry& p) {
  Json list = Json::array();
  for (const Intensity& i : p.at)
    list.push_back(
        {{"direction_deg", {i.horizontal_deg, i.vertical_deg}}, {"intensity_cd", i.candela}});
  return list;
}

Json as_json(const Photometry& p) {
  const PhotometricFileInfo& info = p.data.info;
  const LuminousIntensityDistribution& distribution = p.data.distribution;
  return {{"file", p.file},
          {"format", info.format},
          {"version", info.version},
          {"photometric_type", letter_of(distribution.type())},
          {"symmetry", name_of(info.symmetry)},
          {"horizontal_angles_deg", angles_as_json(distribution.horizontal_deg())},
          {"vertical_angles_deg", angles_as_json(distribution.vertical_deg())},
          {"total_flux_lm", p.flux_lm},
          {"stated_flux_lm", or_null(info.stated_flux_lm)},
          {"lamp_count", info.lamp_count},
          {"lamp_flux_lm", or_null(info.lamp_flux_lm)},
          {"light_output_ratio", or_null(light_output_ratio(p))},
          {"absolute_photometry", info.absolute_photometry},
          {"peak_intensity_cd", p.peak.candela},
          {"peak_direction_deg", {p.peak.horizontal_deg, p.peak.vertical_deg}},
          {"beam_width_50_percent_deg", widths_as_json(p.half)},
          {"beam_width_10_percent_deg", widths_as_json(p.tenth)},
          {"at", at_as_json(p)},
          {"intensity_factor", info.intensity_factor},
          {"input_watts", or_null(info.input_watts)},
          {"luminous_size_m", info.luminous_size_m},
          {"tilt", tilt_as_json(info)},
          {"keywords", keywords_as_json(info)},
          {"warnings", info.warnings}};
}

// As text.

std::string degrees(const std::optional<double>& width, const std::string& along) {
  return (width ? number(*width, 5) + " deg" : std::string("none")) + " along " + along;
}

std::string direction_as_text(const Photometry& p, double horizontal_deg, double vertical_deg) {
  const auto names = angle_names(p.data.distribution.type());
  return names[0] + " " + number(horizontal_deg) + ", " + names[1] + " " + number(vertical_deg);
}

std::string angles_as_text(const std::vector<double>& angles) {
  return std::to_string(angles.size()) + ", from " + number(angles.front()) + " to " +
         number(angles.back()) + " deg";
}

std::string format_as_text(const Photometry& p) {
  const PhotometricFileInfo& info = p.data.info;
  const LuminousIntensityDistribution& distribution = p.data.distribution;
  const auto names = angle_names(distribution.type());
  return line("file", p.file) +
         line("format", info.version.empty() ? info.format : info.format + ", " + info.version) +
         line("photometric type", letter_of(distribution.type())) +
         line("symmetry", name_of(info.symmetry)) +
         line(("angles " + names[0]).c_str(), angles_as_text(distribution.horizontal_deg())) +
         line(("angles " + names[1]).c_str(), angles_as_text(distribution.vertical_deg()));
}

std::string lamps_as_text(const Photometry& p) {
  const PhotometricFileInfo& info = p.data.info;
  std::string text;
  if (info.lamp_count > 0)
    text +=
        line("lamps", std::to_string(info.lamp_count) +
                          (info.lamp_flux_lm ? ", together " + number(*info.lamp_flux_lm) + " lm"
                                             : std::string()) +
                          (info.absolute_photometry ? ", absolute photometry" : ""));
  if (const auto ratio = light_output_ratio(p))
    text += line("light output ratio", fixed(100 * *ratio, 2) + " %");
  if (info.input_watts) text += line("input power", number(*info.input_watts) + " W");
  const auto& size = info.luminous_size_m;
  if (size != std::array<double, 3>{})
    text += line(
        "luminous opening",
        number(size[0]) + " x " + number(size[1]) + " x " + number(size[2]) +
            (p.data.distribution.type() == PhotometricType::c ? " m (along C 90, along C 0, height)"
                                                              : " m (width, length, height)"));
  if (info.intensity_factor != 1)
    text += line("intensity factor", number(info.intensity_factor) + " (applied)");
  if (info.tilt)
    text += line("TILT", std::to_string(info.tilt->angles_deg.size()) + " angles (not applied)");
  return text;
}

std::string light_as_text(const Photometry& p) {
  const PhotometricType type = p.data.distribution.type();
  const std::array<std::string, 2> along =
      type == PhotometricType::c ? std::array<std::string, 2>{"the circle across", "gamma"}
                                 : angle_names(type);
  const auto widths = [&](const BeamWidths& w) {
    return degrees(w.horizontal_deg, along[0]) + ", " + degrees(w.vertical_deg, along[1]);
  };
  std::string text = line("total flux", number(p.flux_lm) + " lm");
  if (const auto& stated = p.data.info.stated_flux_lm)
    text += line("flux as the file says", number(*stated) + " lm");
  text +=
      line("peak", number(p.peak.candela) + " cd at " +
                       direction_as_text(p, p.peak.horizontal_deg, p.peak.vertical_deg) + " deg") +
      line("beam width, 50 %", widths(p.half)) + line("beam width, 10 %", widths(p.tenth));
  for (const Intensity& i : p.at)
    text += line("intensity", number(i.candela) + " cd at " +
                                  direction_as_text(p, i.horizontal_deg, i.vertical_deg) + " deg");
  return text;
}

std::string keywords_as_text(const PhotometricFileInfo& info) {
  std::string text = info.keywords.empty() ? "" : "\nkeywords\n";
  for (const auto& [name, value] : info.keywords)
    text += "  " + padded(printable(name), 26) + " " + printable(value) + "\n";
  return text;
}

std::string as_text(const Photometry& p) {
  return format_as_text(p) + light_as_text(p) + lamps_as_text(p) + keywords_as_text(p.data.info);
}

void run_info(const PhotometryInfoArguments& a) {
  for (const auto& [h, v] : a.at)
    for (const double angle : {h, v}) require_in_range("--at", angle, -720, 720);
  if (a.plot.empty() && (a.plot_range.h_deg || a.plot_range.v_deg))
    throw OptionError("--plot-h-deg and --plot-v-deg go with --plot");
  if (!a.plot.empty()) require_plot_writable(a.plot, a.input.file);
  const Photometry p = photometry_of(a);
  tell_warnings(a.input, p.data.info);
  if (!a.plot.empty()) {
    const std::string title = printable(std::filesystem::path(a.input.file).filename().string());
    const std::string svg = photometry_plot_svg(p.data.distribution, title, a.plot_range);
    write_file_atomically(a.plot, std::as_bytes(std::span(svg)), [] { return !interrupted(); });
  }
  print(a.as_json ? as_json(p).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                  : as_text(p));
}

}  // namespace

Command add_photometry_info_command(CLI::App& photometry) {
  CLI::App& command = *photometry.add_subcommand(
      "info", "Tell a photometric file's type, angles, flux, peak and beam widths");
  const auto arguments = std::make_shared<PhotometryInfoArguments>();
  add_photometry_input(command, arguments->input, "--");
  command.add_option("--at", arguments->at, "Also the intensity in this direction; repeatable")
      ->type_name("H V")
      ->allow_extra_args(false);
  command.add_flag("--json", arguments->as_json, "As JSON");
  command
      .add_option("--plot", arguments->plot,
                  "SVG file to draw in: polar curves for type C, else lines of equal candela")
      ->check(CLI::Validator([](std::string& text) { return text.empty() ? "is empty" : ""; }, ""));
  add_range_option(command, "--plot-h-deg", arguments->plot_range.h_deg,
                   "H that is drawn of type A and B (default: around the bright part)");
  add_range_option(command, "--plot-v-deg", arguments->plot_range.v_deg, "V that is drawn");
  return [arguments] { run_info(*arguments); };
}

}  // namespace glare::tool
