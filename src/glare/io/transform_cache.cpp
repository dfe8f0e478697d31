#include "glare/io/transform_cache.h"

#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glare/base/error.h"
#include "glare/diffraction/transform_plans.h"
#include "glare/io/atomic_file.h"
#include "glare/io/sha256.h"

namespace glare {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostBytes = 1 << 20;
constexpr std::string_view kEndOfHeader = "\n\n";

std::string sha256_of_text(std::string_view text) {
  return sha256_of(std::as_bytes(std::span(text)));
}

/// What tells kinds of processors apart: timings of another one are of no use.
std::string processor() {
  constexpr std::array<std::string_view, 6> kKeys = {"model name", "flags",      "Features",
                                                     "CPU part",   "cache size", "CPU variant"};
  std::ifstream file("/proc/cpuinfo");
  std::string text;
  for (std::string line; std::getline(file, line) && !line.empty();)
    for (const auto key : kKeys)
      if (line.starts_with(key)) text += line + '\n';
  return sha256_of_text(text);
}

/// The whole file that holds such plans.
std::string file_of(std::string_view plans) {
  std::string text = "glare transform plans 1\nlibrary " + transform_library();
  text += "\nprocessor " + processor() + "\nbytes " + std::to_string(plans.size());
  text += "\nsha256 " + sha256_of_text(plans);
  text.append(kEndOfHeader).append(plans);
  return text;
}

/// An absolute path in an environment variable; else empty.
fs::path folder_in(const char* variable) {
  const char* const value = std::getenv(variable);
  const fs::path path = value ? value : "";
  return path.is_absolute() ? path : fs::path();
}

/// Makes the folder and those it is in, where they aren't there, for the user alone.
bool make_folders(const fs::path& folder) {
  if (folder.empty()) return true;
  struct stat status {};
  if (::stat(folder.c_str(), &status) == 0) return S_ISDIR(status.st_mode);
  if (folder.has_relative_path() && !make_folders(folder.parent_path())) return false;
  return ::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST;
}

}  // namespace

fs::path transform_plans_path() {
  fs::path folder = folder_in("XDG_CACHE_HOME");
  if (folder.empty()) {
    folder = folder_in("HOME");
    if (folder.empty()) return {};
    folder /= ".cache";
  }
  return folder / "glare" / "transforms";
}

bool load_transform_plans(const fs::path& path) {
  std::vector<std::byte> bytes;
  try {
    bytes = read_file(path, kMostBytes);
  } catch (const InputError&) {
    return false;
  }
  const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t header = content.find(kEndOfHeader);
  if (header == std::string_view::npos) return false;
  const std::string_view plans = content.substr(header + kEndOfHeader.size());
  return content == file_of(plans) && adopt_transform_plans(std::string(plans));
}

bool store_transform_plans(const fs::path& path) {
  if (path.empty() || !make_folders(path.parent_path())) return false;
  const std::string content = file_of(transform_plans_text());
  if (content.size() > kMostBytes) return false;
  try {
    write_file_atomically(path, std::as_bytes(std::span(content)));
  } catch (const OutputError&) {
    return false;
  }
  return true;
}

}  // namespace glare
