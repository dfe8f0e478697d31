// glare info: what a template is.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
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
};

std::vector<EncircledShare> encircled_shares(const GlareTemplate& t) {
  std::vector<EncircledShare> shares;
  for (const double radius_deg : kRadii_deg)
    if (const auto share = encircled_energy(t, radius_deg)) shares.push_back({radius_deg, *share});
  return shares;
}

Info info_of(const std::string& file) {
  TemplateFile read = read_template_file(file, {default_memory_limit_bytes()});
  Info info{file, std::move(read.glare_template), std::move(read.header), {}, {}, 0, {}, {}, {}};
  const GlareTemplate& t = info.glare_template;
  info.field_of_view_deg = {t.width() * t.pixel_pitch_deg(), t.height() * t.pixel_pitch_deg()};
  info.peak = peak(t);
  info.peak_per_steradian = info.peak.luminance * t.per_steradian;
  info.mean = mean_chromaticity(t);
  info.shares = encircled_shares(t);
  info.rings = radial_profile(t);
  return info;
}

// As JSON.

Json shares_as_json(const Info& info) {
  Json shares = Json::array();
  for (const EncircledShare& s : info.shares)
    shares.push_back({{"radius_deg", s.radius_deg}, {"share_of_light", s.share_of_light}});
  return shares;
}

Json profile_as_json(const Info& info) {
  Json profile = Json::array();
  for (const ProfileRing& ring : info.rings)
    profile.push_back({{"inner_deg", ring.inner_deg},
                       {"outer_deg", ring.outer_deg},
                       {"mean_per_steradian", ring.mean_per_steradian}});
  return profile;
}

Json header_as_json(const Info& info) {
  Json header = Json::object();
  for (const HeaderAttribute& a : info.header)
    header[a.name] = {{"type", a.type}, {"value", a.value}};
  return header;
}

Json as_json(const Info& info) {
  const GlareTemplate& t = info.glare_template;
  return {{"file", info.file},
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
          {"observer", t.observer},
          {"wavelength_range_nm", {t.wavelength_range_nm.lo_nm, t.wavelength_range_nm.hi_nm}},
          {"aperture_width_mm", t.aperture_width_mm},
          {"aperture_area_mm2", t.aperture_area_mm2},
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
}

// As text.

/// The text with spaces for control characters (those of one byte, and U+0080 to U+009F), so that a
/// file can't move a terminal's cursor.
std::string printable(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    if (c < ' ' || c == 0x7F) text[i] = ' ';
    if (c == 0xC2 && next >= 0x80 && next < 0xA0) text[i] = text[i + 1] = ' ';
  }
  return text;
}

/// The text and spaces up to a width.
std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string line(const char* label, const std::string& value) {
  return padded(label, 22) + printable(value) + "\n";
}

std::string number(double value, int digits = 6) {
  char text[64];
  return {text,
          std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

std::string fixed(double value, int decimals) {
  char text[400];
  return {text,
          std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr};
}

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

std::string light_as_text(const Info& info) {
  const GlareTemplate& t = info.glare_template;
  return line("lamp", t.lamp + ", XYZ " + number(t.lamp_xyz[0]) + " " + number(t.lamp_xyz[1]) +
                          " " + number(t.lamp_xyz[2])) +
         line("observer", t.observer) +
         line("wavelengths", number(t.wavelength_range_nm.lo_nm) + " to " +
                                 number(t.wavelength_range_nm.hi_nm) + " nm") +
         line("aperture", number(t.aperture_width_mm) + " mm wide, area " +
                              number(t.aperture_area_mm2) + " mm2") +
         line("peak", number(info.peak.luminance) + " at pixel " + std::to_string(info.peak.x) +
                          ", " + std::to_string(info.peak.y) + "; " +
                          number(info.peak_per_steradian) + " per steradian") +
         line("mean chromaticity", "x " + number(info.mean.x) + ", y " + number(info.mean.y));
}

std::string tables_as_text(const Info& info) {
  std::string text;
  for (const EncircledShare& s : info.shares)
    text += line("light within", number(s.radius_deg) + " deg: " + fixed(s.share_of_light, 4));
  text += "\n  from deg    to deg      mean luminance, per steradian\n";
  for (const ProfileRing& ring : info.rings)
    text += "  " + padded(number(ring.inner_deg, 5), 12) + padded(number(ring.outer_deg, 5), 12) +
            number(ring.mean_per_steradian, 5) + "\n";
  return text;
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

void run_info(const InfoArguments& arguments) {
  const Info info = info_of(arguments.file);
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
  return [arguments] { run_info(*arguments); };
}

}  // namespace glare::tool
