// glare info: what a template is.

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "console.h"
#include "glare/glare.h"
#include "glare/glare_io.h"
#include "info/profile_plot.h"
#include "info_text.h"
#include "svg.h"
#include "template/template_arguments.h"

namespace glare::tool {

namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
  std::string file;
  bool as_json = false;
  bool with_cie = false;
  std::optional<double> age_years, pigment;
  std::string plot;
};

constexpr double kRadii_deg[] = {0.1, 0.5, 1, 2, 5};

struct EncircledShare {
  double radius_deg = 0;
  double share_of_light = 0;
};

/// Everything there is to say of a template.
struct Info {
  std::string file;
  GlareTemplate glare_template;
  std::vector<HeaderAttribute> header;
  std::array<double, 2> field_of_view_deg{};
  Peak peak;
  double peak_per_steradian = 0;
  Chromaticity mean;
  std::vector<EncircledShare> shares;
  std::vector<ProfileRing> rings;
  std::optional<Straylight> cie_eye;  ///< Whose curve is told beside the profile, if any.
  std::vector<std::optional<double>> cie_per_steradian;  ///< Of each ring.
};

std::vector<EncircledShare> encircled_shares(const GlareTemplate& t) {
  std::vector<EncircledShare> shares;
  for (const double radius_deg : kRadii_deg)
    if (const auto share = encircled_energy(t, radius_deg)) shares.push_back({radius_deg, *share});
  return shares;
}

Info info_of(const InfoArguments& arguments) {
  const std::string& file = arguments.file;
  TemplateFile read = read_template_file(file, {default_memory_limit_bytes()});
  Info info{file, std::move(read.glare_template), std::move(read.header), {}, {}, 0, {}, {}, {}, {},
            {}};
  const GlareTemplate& t = info.glare_template;
  info.field_of_view_deg = {t.width() * t.pixel_pitch_deg(), t.height() * t.pixel_pitch_deg()};
  info.peak = peak(t);
  info.peak_per_steradian = info.peak.luminance * t.per_steradian;
  info.mean = mean_chromaticity(t);
  info.shares = encircled_shares(t);
  info.rings = radial_profile(t);
  info.cie_per_steradian.resize(info.rings.size());
  if (arguments.with_cie || !arguments.plot.empty()) {
    info.cie_eye = eye_of(arguments.age_years, arguments.pigment, t.scatter.value_or(Straylight{}));
    info.cie_per_steradian = cie_profile(t, info.rings, *info.cie_eye);
  }
  return info;
}

std::optional<double> ratio_to_cie(const Info& info, std::size_t ring) {
  const auto& cie = info.cie_per_steradian[ring];
  if (!cie) return std::nullopt;
  return info.rings[ring].mean_per_steradian / *cie;
}

// As JSON.

Json shares_as_json(const Info& info) {
  Json shares = Json::array();
  for (const EncircledShare& s : info.shares)
    shares.push_back({{"radius_deg", s.radius_deg}, {"share_of_light", s.share_of_light}});
  return shares;
}

Json number_or_null(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json profile_as_json(const Info& info) {
  Json profile = Json::array();
  for (std::size_t i = 0; i < info.rings.size(); ++i) {
    const ProfileRing& ring = info.rings[i];
    profile.push_back({{"inner_deg", ring.inner_deg},
                       {"outer_deg", ring.outer_deg},
                       {"mean_per_steradian", ring.mean_per_steradian}});
    if (!info.cie_eye) continue;
    profile.back()["cie_per_steradian"] = number_or_null(info.cie_per_steradian[i]);
    profile.back()["ratio_to_cie"] = number_or_null(ratio_to_cie(info, i));
  }
  return profile;
}

Json eye_as_json(const Straylight& eye) {
  return {{"age_years", eye.age_years}, {"pigment", eye.pigment}};
}

Json scatter_as_json(const GlareTemplate& t) {
  if (!t.scatter) return nullptr;
  Json scatter = {{"model", "cie146"}};
  scatter.update(eye_as_json(*t.scatter));
  scatter["scattered_energy"] = t.scattered_energy;
  return scatter;
}

Json header_as_json(const Info& info) {
  Json header = Json::object();
  for (const HeaderAttribute& a : info.header)
    header[a.name] = {{"type", a.type}, {"value", a.value}};
  return header;
}

Json as_json(const Info& info) {
  const GlareTemplate& t = info.glare_template;
  Json json = {{"file", info.file},
               {"width_px", t.width()},
               {"height_px", t.height()},
               {"pixel_pitch_deg", t.pixel_pitch_deg()},
               {"field_of_view_deg", info.field_of_view_deg},
               {"center_px", t.center_px()},
               {"color_space", t.color_space.name()},
               {"normalization", to_string(t.normalization)},
               {"per_steradian", t.per_steradian},
               {"captured_energy", t.captured_energy},
               {"lamp", t.lamp},
               {"lamp_xyz", t.lamp_xyz},
               {"light_xyz", t.light_xyz},
               {"observer", t.observer},
               {"wavelength_range_nm", {t.wavelength_range_nm.lo_nm, t.wavelength_range_nm.hi_nm}},
               {"aperture_width_mm", t.aperture_width_mm},
               {"aperture_area_mm2", t.aperture_area_mm2},
               {"scatter", scatter_as_json(t)},
               {"peak",
                {{"x_px", info.peak.x},
                 {"y_px", info.peak.y},
                 {"luminance", info.peak.luminance},
                 {"per_steradian", info.peak_per_steradian}}},
               {"mean_chromaticity_xy", {info.mean.x, info.mean.y}},
               {"encircled_energy", shares_as_json(info)},
               {"radial_profile", profile_as_json(info)},
               {"recipe", t.recipe},
               {"software", t.software},
               {"header", header_as_json(info)}};
  if (info.cie_eye) json["cie"] = eye_as_json(*info.cie_eye);
  return json;
}

// As text.

std::string scale_as_text(const Info& info) {
  const GlareTemplate& t = info.glare_template;
  const auto center = t.center_px();
  return line("size", std::to_string(t.width()) + " x " + std::to_string(t.height()) + " px") +
         line("pixel pitch", number(t.pixel_pitch_deg()) + " deg (direction sine)") +
         line("field of view", number(info.field_of_view_deg[0]) + " x " +
                                   number(info.field_of_view_deg[1]) + " deg") +
         line("axis at pixel", std::to_string(center[0]) + ", " + std::to_string(center[1])) +
         line("colour space", t.color_space.name()) +
         line("normalization", to_string(t.normalization)) +
         line("1 is per steradian", number(t.per_steradian)) +
         line("captured energy", number(t.captured_energy));
}

std::string eye_as_text(const Straylight& eye) {
  return "age " + number(eye.age_years) + " years, pigment " + number(eye.pigment);
}

std::string scatter_as_text(const GlareTemplate& t) {
  if (!t.scatter) return {};
  return line("scatter", "cie146, " + eye_as_text(*t.scatter) + "; " + number(t.scattered_energy) +
                             " of the light");
}

std::string light_as_text(const Info& info) {
  const GlareTemplate& t = info.glare_template;
  return line("lamp", t.lamp + ", XYZ " + number(t.lamp_xyz[0]) + " " + number(t.lamp_xyz[1]) +
                          " " + number(t.lamp_xyz[2])) +
         line("observer", t.observer) +
         line("wavelengths", number(t.wavelength_range_nm.lo_nm) + " to " +
                                 number(t.wavelength_range_nm.hi_nm) + " nm") +
         line("aperture", number(t.aperture_width_mm) + " mm wide, area " +
                              number(t.aperture_area_mm2) + " mm2") +
         scatter_as_text(t) +
         line("peak", number(info.peak.luminance) + " at pixel " + std::to_string(info.peak.x) +
                          ", " + std::to_string(info.peak.y) + "; " +
                          number(info.peak_per_steradian) + " per steradian") +
         line("mean chromaticity", "x " + number(info.mean.x) + ", y " + number(info.mean.y));
}

/// A ring's place in the table beside the CIE curve: that and the ratio, or dashes.
std::string cie_columns(const Info& info, std::size_t ring) {
  if (!info.cie_eye) return {};
  const auto& cie = info.cie_per_steradian[ring];
  if (!cie) return padded("-", 14) + "-";
  return padded(number(*cie, 5), 14) + number(*ratio_to_cie(info, ring), 4);
}

std::string profile_as_text(const Info& info) {
  std::string text;
  if (info.cie_eye) text += line("CIE general glare", eye_as_text(*info.cie_eye));
  text += "\n  from deg    to deg      mean luminance, per steradian\n";
  if (info.cie_eye)
    text += "                          template      CIE           template / CIE\n";
  for (std::size_t i = 0; i < info.rings.size(); ++i) {
    const ProfileRing& ring = info.rings[i];
    const std::string mean = number(ring.mean_per_steradian, 5);
    text += "  " + padded(number(ring.inner_deg, 5), 12) + padded(number(ring.outer_deg, 5), 12) +
            (info.cie_eye ? padded(mean, 14) : mean) + cie_columns(info, i) + "\n";
  }
  return text;
}

std::string tables_as_text(const Info& info) {
  std::string text;
  for (const EncircledShare& s : info.shares)
    text += line("light within", number(s.radius_deg) + " deg: " + fixed(s.share_of_light, 4));
  return text + profile_as_text(info);
}

std::string header_as_text(const Info& info) {
  std::string text = "\nheader\n";
  for (const HeaderAttribute& a : info.header)
    text += "  " + padded(printable(a.name), 26) + " " + padded(printable(a.type), 16) + " " +
            printable(a.value) + "\n";
  return text;
}

std::string as_text(const Info& info) {
  return line("file", info.file) + scale_as_text(info) + light_as_text(info) +
         tables_as_text(info) + header_as_text(info);
}

void require_consistent(const InfoArguments& a) {
  if ((a.age_years || a.pigment) && !a.with_cie && a.plot.empty())
    throw OptionError(std::string(a.age_years ? "--age" : "--pigment") +
                      " goes with --cie or --plot");
  if (!a.plot.empty()) require_plot_writable(a.plot, a.file);
  eye_of(a.age_years, a.pigment);
}

ProfilePlot plot_of(const Info& info) {
  const GlareTemplate& t = info.glare_template;
  const std::string aperture = number(t.aperture_width_mm, 4) + " mm aperture";
  const std::string eye = eye_as_text(*info.cie_eye);
  return {"Glare of lamp " + printable(t.lamp) + ", " + aperture +
              (t.scatter ? ", scatter for " + eye_as_text(*t.scatter) : ", diffraction alone"),
          "CIE general glare equation, " + eye, info.rings, *info.cie_eye};
}

void run_info(const InfoArguments& arguments) {
  require_consistent(arguments);
  const Info info = info_of(arguments);
  if (!arguments.plot.empty()) {
    const std::string svg = profile_plot_svg(plot_of(info));
    write_file_atomically(arguments.plot, std::as_bytes(std::span(svg)));
  }
  print(arguments.as_json ? as_json(info).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                          : as_text(info));
}

}  // namespace

Command add_info_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "info", "Tell a template's scale, field, lamp, peak, captured energy and radial profile");
  const auto arguments = std::make_shared<InfoArguments>();
  command.add_option("file", arguments->file, "OpenEXR file of a template")->required();
  command.add_flag("--json", arguments->as_json, "As JSON");
  command.add_flag("--cie", arguments->with_cie,
                   "The profile beside the CIE general glare equation (CIE 146:2002)");
  add_eye_options(command, arguments->age_years, arguments->pigment);
  for (const char* name : {"--age", "--pigment"})
    command.get_option(name)->default_str("")->description(
        command.get_option(name)->get_description() +
        " (default: the template's own, else 35 years, brown)");
  command
      .add_option("--plot", arguments->plot,
                  "SVG file to draw the profile and the CIE equation in, log-log")
      ->check(CLI::Validator([](std::string& text) { return text.empty() ? "is empty" : ""; }, ""));
  return [arguments] { run_info(*arguments); };
}

}  // namespace glare::tool
