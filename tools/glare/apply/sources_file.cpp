#include "apply/sources_file.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "glare/base/error.h"
#include "glare/base/text_fields.h"
#include "glare/io/atomic_file.h"

namespace glare::tool {

namespace {

constexpr std::uint64_t kLargestFile_bytes = std::uint64_t{256} << 20;
constexpr std::size_t kMostPoints = 1'000'000;
constexpr double kFarthest_px = 1e6;
constexpr std::size_t kColumns = 5;

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

bool has_a_number(const std::vector<std::string_view>& fields) {
  for (const std::string_view field : fields)
    if (number_from(field)) return true;
  return false;
}

PointSource point_from(const std::vector<std::string_view>& fields, const std::string& here) {
  std::array<double, kColumns> numbers{};
  for (std::size_t i = 0; i < kColumns; ++i) {
    const auto number = fields.size() == kColumns ? number_from(fields[i]) : std::nullopt;
    if (!number) throw InputError(here, "expected five numbers, x_px,y_px,red,green,blue");
    numbers[i] = *number;
  }
  PointSource point{numbers[0], numbers[1], {}};
  if (!(std::abs(point.x_px) <= kFarthest_px && std::abs(point.y_px) <= kFarthest_px))
    throw InputError(here, "the place is farther than a million pixels away");
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(numbers[k + 2] >= 0 && numbers[k + 2] <= 1e30))
      throw InputError(here, "the light isn't a number from 0 to 1e30");
    point.light[k] = static_cast<float>(numbers[k + 2]);
  }
  return point;
}

}  // namespace

std::vector<PointSource> parse_sources(std::string_view text, const std::string& place) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<PointSource> points;
  bool header_allowed = true;
  for (int line_number = 1; !text.empty(); ++line_number) {
    const std::string_view whole = next_line(text);
    const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
    if (line.empty()) continue;
    const auto fields = fields_of(line);
    const bool is_header = header_allowed && fields.size() == kColumns && !has_a_number(fields);
    header_allowed = false;
    if (is_header) continue;
    points.push_back(point_from(fields, at_line(place, line_number)));
    if (points.size() > kMostPoints)
      throw InputError(at_line(place, line_number), "there are more than a million points");
  }
  if (points.empty()) throw InputError(place, "has no rows of x_px,y_px,red,green,blue");
  return points;
}

std::vector<PointSource> read_sources_file(const std::filesystem::path& path) {
  const auto bytes = read_file(path, kLargestFile_bytes);
  return parse_sources({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string());
}

}  // namespace glare::tool
