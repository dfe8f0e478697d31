// Tables of a TOML file, read key by key: what is wrong is told with its line.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glare::tool {

/// The numbers that a key may have.
struct NumberRange {
  double low, high;
};

/// A table of a file. Every reader throws `InputError`, whose place is "FILE:LINE", where the key
/// has a value of another kind or outside its range; a key that isn't there gives nothing.
class TomlTable {
 public:
  /// The whole file's table. Throws `InputError` where it can't be read or isn't TOML.
  static TomlTable read(const std::filesystem::path& file);

  /// Where the table begins, "FILE:LINE".
  std::string place() const;
  /// Where a key's value stands; the table's place where it has no such key.
  std::string place_of(const std::string& key) const;
  bool has(const std::string& key) const;

  std::optional<double> number(const std::string& key, NumberRange range) const;
  std::optional<int> whole_number(const std::string& key, NumberRange range) const;
  std::optional<bool> truth(const std::string& key) const;
  /// Not empty.
  std::optional<std::string> text(const std::string& key) const;
  /// One of a few words.
  std::optional<std::string> word(const std::string& key,
                                  const std::vector<std::string>& words) const;
  /// A file's name, relative to the folder of the TOML file.
  std::optional<std::filesystem::path> file(const std::string& key) const;
  /// As many numbers as `count`.
  std::optional<std::vector<double>> numbers(const std::string& key, std::size_t count,
                                             NumberRange range) const;
  /// Two whole numbers.
  std::optional<std::array<int, 2>> size(const std::string& key, NumberRange range) const;
  /// One or more points of three numbers.
  std::vector<std::vector<double>> points(const std::string& key, NumberRange range) const;

  /// A table within this one; an empty one where there is none.
  TomlTable table(const std::string& key) const;
  /// The tables of an array, [[key]].
  std::vector<TomlTable> tables(const std::string& key) const;

  /// Throws `InputError` for the first key that none of the functions above asked for.
  void require_all_keys_known() const;

 private:
  struct Parts;
  explicit TomlTable(std::shared_ptr<Parts> parts);
  std::shared_ptr<Parts> parts_;
};

}  // namespace glare::tool
