#include "table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace glare::bench {

namespace {

using Cells = std::array<std::string, 4>;

std::string with_unit(double value, const std::string& unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g%s%s", value, unit.empty() ? "" : " ", unit.c_str());
  return text;
}

std::string limit_text(const std::optional<double>& limit, const RowTitle& title) {
  if (!limit) return "";
  return (title.at_least ? "≥ " : "≤ ") + with_unit(*limit, title.unit);
}

Cells cells_of(const Row& row) {
  return {row.title.what, with_unit(row.measurement.value(), row.title.unit),
          limit_text(row.title.reach, row.title), limit_text(row.title.stretch, row.title)};
}

/// Characters, not bytes, of UTF-8.
std::size_t length(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

std::string markdown(const std::vector<std::unique_ptr<Row>>& rows) {
  std::vector<Cells> table = {{"what", "measured", "reach", "stretch"},
                              {"---", "---", "---", "---"}};
  std::string notes;
  for (const auto& row : rows) {
    if (row->measurement.empty()) continue;
    table.push_back(cells_of(*row));
    const std::string note = row->measurement.notes(row->title.unit);
    if (!note.empty()) notes += "- " + row->title.what + ": " + note + ".\n";
  }
  std::array<std::size_t, 4> widths{};
  for (const Cells& cells : table)
    for (std::size_t i = 0; i < cells.size(); ++i)
      widths[i] = std::max(widths[i], length(cells[i]));
  std::string out;
  for (const Cells& cells : table) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      out += (i ? " | " : "| ") + cells[i] + std::string(widths[i] - length(cells[i]), ' ');
    out += " |\n";
  }
  return out + '\n' + notes;
}

std::string json(const std::vector<std::unique_ptr<Row>>& rows) {
  const auto number_or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  };
  auto list = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    if (row->measurement.empty()) continue;
    list.push_back({{"what", row->title.what},
                    {"value", row->measurement.value()},
                    {"unit", row->title.unit},
                    {"reach", number_or_null(row->title.reach)},
                    {"stretch", number_or_null(row->title.stretch)},
                    {"at_least", row->title.at_least}});
  }
  return list.dump(1) + '\n';
}

}  // namespace glare::bench
