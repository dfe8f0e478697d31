#include "glare/io/radiance/hdr_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string_view>

#include "glare/io/file_color_space.h"

namespace glare::radiance_io {

using image_io::Bytes;
using image_io::require;

namespace {

constexpr std::size_t kMostHeaderBytes = 1 << 20;
constexpr std::string_view kRgbe = "FORMAT=32-bit_rle_rgbe", kXyze = "FORMAT=32-bit_rle_xyze";

/// The numbers in a line after its name, as many as there are.
std::vector<double> numbers_in(std::string_view text) {
  std::istringstream words{std::string(text)};
  words.imbue(std::locale::classic());
  return {std::istream_iterator<double>(words), {}};
}

std::string_view value_of(std::string_view line, std::string_view name) {
  return line.starts_with(name) ? line.substr(name.size()) : std::string_view();
}

void note_line(const std::string& line, HdrHeader& header, bool& xyz) {
  if (line == kXyze) xyz = true;
  if (const auto text = value_of(line, "PIXASPECT="); !text.empty()) {
    const std::vector<double> numbers = numbers_in(text);
    require(numbers.size() == 1 && numbers[0] > 1e-6 && numbers[0] < 1e6,
            "the line PIXASPECT is damaged");
    header.pixel_aspect /= numbers[0];
  }
  if (const auto text = value_of(line, "PRIMARIES="); !text.empty()) {
    const std::vector<double> n = numbers_in(text);
    require(n.size() == 8, "the line PRIMARIES is damaged");
    header.color_space =
        color_space_with({{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, {n[6], n[7]}}});
  }
}

std::string text_of(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number, std::chars_format::general, 6).ptr};
}

}  // namespace

HdrHeader hdr_header(const Bytes& file) {
  const std::string_view text = image_io::text_of(file).substr(0, kMostHeaderBytes);
  const std::size_t end = text.find("\n\n");
  require(end != std::string_view::npos, "the header is damaged");
  HdrHeader header;
  std::istringstream lines{std::string(text.substr(0, end))};
  bool xyz = false;
  for (std::string line; std::getline(lines, line);) {
    note_line(line, header, xyz);
    header.lines.push_back(line);
  }
  if (xyz) header.color_space = xyz_color_space();
  return header;
}

HdrHeader new_hdr_header(const RgbColorSpace& space, double pixel_aspect) {
  HdrHeader header = {{"#?RADIANCE", "SOFTWARE=glare " GLARE_VERSION}, space, pixel_aspect};
  if (!space.is_xyz()) {
    std::string primaries = "PRIMARIES=";
    for (const Chromaticity& c : chromaticities_of(space))
      primaries.append(text_of(c.x)).append(" ").append(text_of(c.y)).append(" ");
    primaries.pop_back();
    header.lines.push_back(primaries);
  }
  if (pixel_aspect != 1) header.lines.push_back("PIXASPECT=" + text_of(1 / pixel_aspect));
  header.lines.emplace_back(space.is_xyz() ? kXyze : kRgbe);
  return header;
}

std::optional<ToldPixelPitch> told_pixel_pitch(const HdrHeader& header, int width) {
  const auto view = std::find_if(header.lines.rbegin(), header.lines.rend(),
                                 [](const auto& line) { return line.starts_with("VIEW="); });
  if (view == header.lines.rend()) return {};
  const std::size_t type = view->find("-vt"), angle = view->find("-vh ");
  if (angle == std::string::npos || (type != std::string::npos && view->substr(type, 4) != "-vtv"))
    return {};
  const std::vector<double> fov_deg = numbers_in(std::string_view(*view).substr(angle + 4));
  if (fov_deg.empty() || !(fov_deg[0] > 0 && fov_deg[0] < 180)) return {};
  return ToldPixelPitch{2 * std::tan(0.5 * fov_deg[0] * std::numbers::pi / 180) / width,
                        "VIEW (-vh)"};
}

void call_rgbe(Bytes& file) {
  const std::string_view text = image_io::text_of(file).substr(0, kMostHeaderBytes);
  const std::string_view lines = text.substr(0, text.find("\n\n"));
  for (std::size_t at = lines.find(kXyze); at != std::string_view::npos;
       at = lines.find(kXyze, at + 1))
    std::ranges::transform(kRgbe, file.begin() + static_cast<std::ptrdiff_t>(at),
                           [](char c) { return static_cast<std::byte>(c); });
}

}  // namespace glare::radiance_io
