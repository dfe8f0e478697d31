// glare info: what a template is.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "console.h"
#include "glare/glare.h"
#include "glare/glare_io.h"

namespace glare::tool {

namespace {

using Json = nlohmann::ordered_json;

struct InfoArguments {
  std::string file;
  bool as_json = false;
};

constexpr double kRadii_deg[] = {0.1, 0.5, 1, 2, 5};

Json header_as_json(const std::string& file) {
  Json header = Json::object();
  for (const HeaderAttribute& a : read_header(file))
    header[a.name] = {{"type", a.type}, {"value", a.value}};
  return header;
}

Json profile_as_json(const GlareTemplate& t) {
  Json profile = Json::array();
  for (const ProfileRing& ring : radial_profile(t))
    profile.push_back({{"inner_deg", ring.inner_deg},
                       {"outer_deg", ring.outer_deg},
                       {"mean_per_steradian", ring.mean_per_steradian}});
  return profile;
}

Json shares_as_json(const GlareTemplate& t) {
  Json shares = Json::array();
  for (const double radius_deg : kRadii_deg)
    if (const auto share = encircled_energy(t, radius_deg))
      shares.push_back({{"radius_deg", radius_deg}, {"share_of_light", *share}});
  return shares;
}

/// Everything there is to say; the text is made from it too.
Json info(const std::string& file) {
  const GlareTemplate t = read_template(file);
  const Peak brightest = peak(t);
  const Chromaticity mean = mean_chromaticity(t);
  const auto center = t.center_px();
  return {
      {"file", file},
      {"width_px", t.width()},
      {"height_px", t.height()},
      {"pixel_pitch_deg", t.pixel_pitch_deg()},
      {"field_of_view_deg", {t.width() * t.pixel_pitch_deg(), t.height() * t.pixel_pitch_deg()}},
      {"center_px", {center[0], center[1]}},
      {"color_space", t.color_space.name()},
      {"normalization", to_string(t.normalization)},
      {"per_steradian", t.per_steradian},
      {"captured_energy", t.captured_energy},
      {"lamp", t.lamp},
      {"lamp_xyz", t.lamp_xyz},
      {"observer", t.observer},
      {"wavelength_range_nm", {t.wavelength_range_nm.lo_nm, t.wavelength_range_nm.hi_nm}},
      {"aperture_width_mm", t.aperture_width_mm},
      {"aperture_area_mm2", t.aperture_area_mm2},
      {"peak",
       {{"x_px", brightest.x},
        {"y_px", brightest.y},
        {"luminance", brightest.luminance},
        {"per_steradian", brightest.luminance * t.per_steradian}}},
      {"mean_chromaticity_xy", {mean.x, mean.y}},
      {"encircled_energy", shares_as_json(t)},
      {"radial_profile", profile_as_json(t)},
      {"recipe", t.recipe},
      {"software", t.software},
      {"header", header_as_json(file)}};
}

std::string line(const char* label, const std::string& value) {
  char text[64];
  std::snprintf(text, sizeof text, "%-22s", label);
  return text + value + "\n";
}

template <typename... Numbers>
std::string formatted(const char* format, Numbers... numbers) {
  char text[200];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

std::string number(const Json& value) { return formatted("%.6g", value.get<double>()); }

std::string scale_as_text(const Json& i) {
  return line("size",
              formatted("%d x %d px", i["width_px"].get<int>(), i["height_px"].get<int>())) +
         line("pixel pitch", number(i["pixel_pitch_deg"]) + " deg (direction sine)") +
         line("field of view", number(i["field_of_view_deg"][0]) + " x " +
                                   number(i["field_of_view_deg"][1]) + " deg") +
         line("axis at pixel", number(i["center_px"][0]) + ", " + number(i["center_px"][1])) +
         line("colour space", i["color_space"]) + line("normalization", i["normalization"]) +
         line("1 is per steradian", number(i["per_steradian"])) +
         line("captured energy", number(i["captured_energy"]));
}

std::string light_as_text(const Json& i) {
  return line("lamp", i["lamp"].get<std::string>() + ", XYZ " + number(i["lamp_xyz"][0]) + " " +
                          number(i["lamp_xyz"][1]) + " " + number(i["lamp_xyz"][2])) +
         line("observer", i["observer"]) +
         line("wavelengths", number(i["wavelength_range_nm"][0]) + " to " +
                                 number(i["wavelength_range_nm"][1]) + " nm") +
         line("aperture", number(i["aperture_width_mm"]) + " mm wide, area " +
                              number(i["aperture_area_mm2"]) + " mm2") +
         line("peak", number(i["peak"]["luminance"]) + " at pixel " + number(i["peak"]["x_px"]) +
                          ", " + number(i["peak"]["y_px"]) + "; " +
                          number(i["peak"]["per_steradian"]) + " per steradian") +
         line("mean chromaticity", "x " + number(i["mean_chromaticity_xy"][0]) + ", y " +
                                       number(i["mean_chromaticity_xy"][1]));
}

std::string tables_as_text(const Json& i) {
  std::string text;
  for (const Json& share : i["encircled_energy"])
    text += line("light within", number(share["radius_deg"]) + " deg: " +
                                     formatted("%.4f", share["share_of_light"].get<double>()));
  text += "\n  from deg    to deg      mean luminance, per steradian\n";
  for (const Json& ring : i["radial_profile"])
    text += formatted("  %-11.5g %-11.5g %.5g\n", ring["inner_deg"].get<double>(),
                      ring["outer_deg"].get<double>(), ring["mean_per_steradian"].get<double>());
  return text;
}

std::string header_as_text(const Json& i) {
  std::string text = "\nheader\n";
  for (const auto& [name, attribute] : i["header"].items())
    text +=
        formatted("  %-26s %-16s ", name.c_str(), attribute["type"].get<std::string>().c_str()) +
        attribute["value"].get<std::string>() + "\n";
  return text;
}

void run_info(const InfoArguments& arguments) {
  const Json i = info(arguments.file);
  if (arguments.as_json) {
    print(i.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    return;
  }
  print(line("file", i["file"]) + scale_as_text(i) + light_as_text(i) + tables_as_text(i) +
        header_as_text(i));
}

}  // namespace

Command add_info_command(CLI::App& program) {
  CLI::App& command = *program.add_subcommand(
      "info", "Tell a template's scale, field, lamp, peak, captured energy and radial profile");
  const auto arguments = std::make_shared<InfoArguments>();
  command.add_option("file", arguments->file, "OpenEXR file of a template")->required();
  command.add_flag("--json", arguments->as_json, "As JSON");
  return [arguments] { run_info(*arguments); };
}

}  // namespace glare::tool
