#include "glare/io/zernike_file.h"

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "glare/base/error.h"
#include "glare/base/text_fields.h"
#include "glare/io/atomic_file.h"

namespace glare {

namespace {

constexpr std::uint64_t kLargestTable_bytes = 1'000'000;
constexpr double kMost_um = 1000, kNarrowest_mm = 0.1, kWidest_mm = 50;
constexpr std::string_view kDiameterName = "pupil_diameter_mm";

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const auto comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

std::optional<int> whole_number_from(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// Takes the lines one by one.
class TableReader {
 public:
  explicit TableReader(const std::string& place) : place_(place) {}

  void take(std::string_view line, int line_number) {
    line_number_ = line_number;
    const auto fields = fields_of(line);
    if (fields[0] == kDiameterName) return take_diameter(fields);
    const bool words = !number_from(fields[0]);
    if (words && !header_seen_ && columns_ == 0) {
      header_seen_ = true;
      return;
    }
    take_row(fields);
  }

  ZernikeWavefront result() const {
    if (!(result_.pupil_diameter_mm > 0))
      throw InputError(place_, "has no line pupil_diameter_mm,D");
    if (result_.coefficients.empty()) throw InputError(place_, "has no rows j,coefficient_um");
    return result_;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(place_ + ":" + std::to_string(line_number_), message);
  }

  void take_diameter(const std::vector<std::string_view>& fields) {
    const auto diameter = fields.size() == 2 ? number_from(fields[1]) : std::nullopt;
    if (!diameter || !(*diameter >= kNarrowest_mm && *diameter <= kWidest_mm))
      fail("expected pupil_diameter_mm,D with D from 0.1 to 50");
    if (result_.pupil_diameter_mm > 0) fail("the pupil's diameter is there twice");
    result_.pupil_diameter_mm = *diameter;
  }

  void take_row(const std::vector<std::string_view>& fields) {
    if (columns_ == 0) columns_ = fields.size();
    if (fields.size() != columns_ || (columns_ != 2 && columns_ != 3))
      fail("expected rows of j,coefficient_um, or all of n,m,coefficient_um");
    const int j = index_from(fields);
    const auto value = number_from(fields.back());
    if (!value || !(std::abs(*value) <= kMost_um))
      fail("the coefficient isn't a number of at most 1000 um");
    const auto [earlier, is_new] = line_of_.emplace(j, line_number_);
    if (!is_new)
      fail("the polynomial stands in line " + std::to_string(earlier->second) + " already");
    result_.coefficients.push_back({j, *value});
  }

  int index_from(const std::vector<std::string_view>& fields) const {
    const auto first = whole_number_from(fields[0]);
    const auto second = whole_number_from(fields[1]);
    if (columns_ == 2 && first && *first >= 0 && *first <= highest_zernike_j()) return *first;
    if (columns_ == 3 && first && second && is_valid({*first, *second}))
      return zernike_j({*first, *second});
    fail(columns_ == 2 ? "j isn't a whole number from 0 to " + std::to_string(highest_zernike_j())
                       : "n and m are no Zernike polynomial's of order up to " +
                             std::to_string(kHighestZernikeOrder));
  }

  const std::string& place_;
  int line_number_ = 0;
  bool header_seen_ = false;
  std::size_t columns_ = 0;
  std::map<int, int> line_of_;
  ZernikeWavefront result_;
};

}  // namespace

ZernikeWavefront parse_zernike_table(std::string_view text, const std::string& place) {
  if (text.find('\0') != std::string_view::npos)
    throw InputError(place, "is not a text file of j,coefficient_um rows");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  TableReader reader(place);
  for (int line_number = 1; !text.empty(); ++line_number) {
    const auto end = text.find('\n');
    const std::string_view whole = text.substr(0, end);
    const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
    if (!line.empty()) reader.take(line, line_number);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.result();
}

ZernikeWavefront read_zernike_file(const std::filesystem::path& path) {
  const auto bytes = read_file(path, kLargestTable_bytes);
  return parse_zernike_table({reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                             path.string());
}

}  // namespace glare
