#include "glare/photometry/ies_header.h"

#include <algorithm>

#include "glare/base/error.h"

namespace glare::photometry {

namespace {

bool is_version_line(std::string_view line) {
  const std::string text = in_upper_case(trimmed(line));
  for (const char* start : {"IESNA", "IES:", "IES LM", "IES-LM", "IESLM", "LM-63", "ANSI/IES"})
    if (text.starts_with(start)) return true;
  return false;
}

/// 0 where it isn't known. "IESNA:LM-63-2002", "IESNA91", "IESNA LM-63-95", ...
int year_of(std::string_view version_line) {
  const std::string text = in_upper_case(version_line);
  constexpr const char* kDigits = "0123456789";
  for (auto begin = text.find_first_of(kDigits); begin != std::string::npos;) {
    const auto end = std::min(text.find_first_not_of(kDigits, begin), text.size());
    const std::string number = text.substr(begin, end - begin);
    for (const int year : {1986, 1991, 1995, 2002, 2019}) {
      const std::string name = std::to_string(year);
      if (number == name || number == name.substr(2)) return year;
    }
    begin = text.find_first_of(kDigits, end);
  }
  return 0;
}

void note_keyword(std::string_view line, IesHeader& header) {
  const std::string_view text = trimmed(line);
  const auto end = text.find(']');
  if (text.empty()) return;
  if (text.front() != '[' || end == std::string_view::npos) {
    header.keywords.emplace_back("", readable(text));
    return;
  }
  const std::string name = in_upper_case(readable(trimmed(text.substr(1, end - 1))));
  const std::string value = readable(trimmed(text.substr(end + 1)));
  if (name == "MORE" && !header.keywords.empty()) {
    std::string& earlier = header.keywords.back().second;
    earlier += (earlier.empty() || value.empty() ? "" : " ") + value;
  } else {
    header.keywords.emplace_back(name, value);
  }
}

}  // namespace

std::optional<std::string_view> tilt_value(std::string_view line) {
  const std::string_view text = trimmed(line);
  if (in_upper_case(text.substr(0, 4)) != "TILT") return std::nullopt;
  const std::string_view rest = trimmed(text.substr(4));
  if (!rest.starts_with('=')) return std::nullopt;
  return trimmed(rest.substr(1));
}

IesHeader ies_header_from(Lines& lines, const std::string& place,
                          std::vector<std::string>& warnings) {
  IesHeader header;
  bool first = true;
  while (const auto line = lines.next()) {
    if (const auto tilt = tilt_value(*line)) {
      header.tilt = *tilt;
      return header;
    }
    if (trimmed(*line).empty()) continue;
    if (std::exchange(first, false) && is_version_line(*line)) {
      header.version = readable(trimmed(*line));
      header.year = year_of(header.version);
      if (header.year == 0) {
        warnings.push_back("the version " + quoted(header.version) +
                           " isn't known; it is taken as LM-63-2002");
        header.year = 2002;
      }
      continue;
    }
    note_keyword(*line, header);
  }
  throw InputError(at_line(place, std::max(1, lines.number())),
                   "the file ends without a line TILT=; is it an IES LM-63 file?");
}

}  // namespace glare::photometry
