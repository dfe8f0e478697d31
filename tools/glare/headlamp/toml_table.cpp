#include "headlamp/toml_table.h"

#include <toml++/toml.h>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "aperture/eye_arguments.h"
#include "glare/base/error.h"
#include "glare/io/atomic_file.h"

namespace glare::tool {

namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{16} << 20;

std::string quoted(const std::string& text) { return std::string("'").append(text).append("'"); }

std::string range_text(NumberRange range) {
  return "a number from " + text_of(range.low) + " to " + text_of(range.high);
}

/// A number, whole or not, within the range; else nothing.
std::optional<double> number_in(const toml::node& node, NumberRange range) {
  const auto number = node.value<double>();
  if (!node.is_number() || !number || !(*number >= range.low && *number <= range.high))
    return std::nullopt;
  return number;
}

/// So many numbers of an array; else nothing.
std::optional<std::vector<double>> numbers_in(const toml::node& node, std::size_t count,
                                              NumberRange range) {
  const toml::array* const array = node.as_array();
  if (array == nullptr || array->size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& element : *array) {
    const auto number = number_in(element, range);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

struct TomlTable::Parts {
  std::shared_ptr<const toml::table> whole;  ///< Owns the file's tables.
  const toml::table* table = nullptr;
  std::filesystem::path path;
  std::string name;  ///< "[viewer]"; empty for the whole file.
  unsigned line = 1;
  std::set<std::string> known;

  std::string place_at(unsigned at) const { return path.string() + ":" + std::to_string(at); }
  std::string place_of(const toml::node& node) const { return place_at(node.source().begin.line); }

  const toml::node* find(const std::string& key) {
    known.insert(key);
    return table->get(key);
  }
  [[noreturn]] void refuse(const toml::node& node, const std::string& key,
                           const std::string& expected) const {
    throw InputError(place_of(node), key + ": expected " + expected);
  }
};

TomlTable::TomlTable(std::shared_ptr<Parts> parts) : parts_(std::move(parts)) {}

TomlTable TomlTable::read(const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = read_file(file, kMostBytes);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  auto parts = std::make_shared<Parts>();
  parts->path = file;
  try {
    parts->whole = std::make_shared<const toml::table>(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw InputError(parts->place_at(error.source().begin.line),
                     "column " + std::to_string(error.source().begin.column) + ": " +
                         std::string(error.description()));
  }
  parts->table = parts->whole.get();
  return TomlTable(std::move(parts));
}

std::string TomlTable::place() const { return parts_->place_at(parts_->line); }

std::string TomlTable::place_of(const std::string& key) const {
  const toml::node* const node = parts_->table->get(key);
  return node == nullptr ? place() : parts_->place_of(*node);
}

bool TomlTable::has(const std::string& key) const { return parts_->find(key) != nullptr; }

std::optional<double> TomlTable::number(const std::string& key, NumberRange range) const {
  const toml::node* const node = parts_->find(key);
  if (node == nullptr) return std::nullopt;
  const auto number = number_in(*node, range);
  if (!number) parts_->refuse(*node, key, range_text(range));
  return number;
}

std::optional<int> TomlTable::whole_number(const std::string& key, NumberRange range) const {
  const auto value = number(key, range);
  if (!value) return std::nullopt;
  if (std::floor(*value) != *value)
    parts_->refuse(*parts_->table->get(key), key, "a whole number, found " + text_of(*value));
  return static_cast<int>(*value);
}

std::optional<bool> TomlTable::truth(const std::string& key) const {
  const toml::node* const node = parts_->find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_boolean()) parts_->refuse(*node, key, "true or false");
  return node->value<bool>();
}

std::optional<std::string> TomlTable::text(const std::string& key) const {
  const toml::node* const node = parts_->find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) parts_->refuse(*node, key, "text in quotation marks");
  std::string value = *node->value<std::string>();
  if (value.empty() || value.find('\0') != std::string::npos)
    parts_->refuse(*node, key, "text that isn't empty");
  return value;
}

std::optional<std::string> TomlTable::word(const std::string& key,
                                           const std::vector<std::string>& words) const {
  const auto value = text(key);
  if (!value) return std::nullopt;
  std::string expected;
  for (const std::string& word : words) {
    if (word == *value) return value;
    expected += (expected.empty() ? "" : ", ") + quoted(word);
  }
  parts_->refuse(*parts_->table->get(key), key, "one of " + expected + ", found " + quoted(*value));
}

std::optional<std::filesystem::path> TomlTable::file(const std::string& key) const {
  const auto name = text(key);
  if (!name) return std::nullopt;
  return parts_->path.parent_path() / *name;
}

std::optional<std::vector<double>> TomlTable::numbers(const std::string& key, std::size_t count,
                                                      NumberRange range) const {
  const toml::node* const node = parts_->find(key);
  if (node == nullptr) return std::nullopt;
  auto numbers = numbers_in(*node, count, range);
  if (!numbers)
    parts_->refuse(*node, key,
                   "an array of " + std::to_string(count) + " numbers, each " + range_text(range));
  return numbers;
}

std::optional<std::array<int, 2>> TomlTable::size(const std::string& key, NumberRange range) const {
  const auto both = numbers(key, 2, range);
  if (!both) return std::nullopt;
  for (const double number : *both)
    if (std::floor(number) != number)
      parts_->refuse(*parts_->table->get(key), key, "whole numbers, found " + text_of(number));
  return std::array{static_cast<int>((*both)[0]), static_cast<int>((*both)[1])};
}

std::vector<std::vector<double>> TomlTable::points(const std::string& key,
                                                   NumberRange range) const {
  const toml::node* const node = parts_->find(key);
  if (node == nullptr) return {};
  std::vector<std::vector<double>> points;
  const auto refuse = [&] [[noreturn]] (const toml::node& where) {
    parts_->refuse(where, key, "an array of arrays of 3 numbers, each " + range_text(range));
  };
  if (!node->is_array() || node->as_array()->empty()) refuse(*node);
  for (const toml::node& element : *node->as_array()) {
    auto point = numbers_in(element, 3, range);
    if (!point) refuse(element);
    points.push_back(std::move(*point));
  }
  return points;
}

TomlTable TomlTable::table(const std::string& key) const {
  static const toml::table none;
  const toml::node* const node = parts_->find(key);
  if (node != nullptr && !node->is_table())
    parts_->refuse(*node, key, std::string("a table, [").append(key).append("]"));
  auto parts = std::make_shared<Parts>(*parts_);
  parts->table = node == nullptr ? &none : node->as_table();
  parts->name = std::string("[").append(key).append("]");
  if (node != nullptr) parts->line = node->source().begin.line;
  parts->known.clear();
  return TomlTable(std::move(parts));
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  const toml::node* const node = parts_->find(key);
  if (node == nullptr) return {};
  const std::string name = std::string("[[").append(key).append("]]");
  if (!node->is_array()) parts_->refuse(*node, key, "tables that each begin with " + name);
  std::vector<TomlTable> tables;
  for (const toml::node& element : *node->as_array()) {
    if (!element.is_table()) parts_->refuse(element, key, "tables that each begin with " + name);
    auto parts = std::make_shared<Parts>(*parts_);
    parts->table = element.as_table();
    parts->name = name;
    parts->line = element.source().begin.line;
    parts->known.clear();
    tables.push_back(TomlTable(std::move(parts)));
  }
  return tables;
}

void TomlTable::require_all_keys_known() const {
  for (const auto& [key, node] : *parts_->table) {
    const std::string name(key.str());
    if (parts_->known.contains(name)) continue;
    std::string expected;
    for (const std::string& known : parts_->known)
      expected += (expected.empty() ? "" : ", ") + known;
    const std::string where = parts_->name.empty() ? "" : " in " + parts_->name;
    throw InputError(parts_->place_at(key.source().begin.line),
                     "unknown key " + quoted(name) + where + "; there are " + expected);
  }
}

}  // namespace glare::tool
