#include "glare/io/memory.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>

namespace glare {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kUnlimited = UINT64_MAX;

/// The number in a file of the cgroup file system; unlimited where there is no such file or number.
std::uint64_t limit_in(const fs::path& file_name) {
  std::ifstream file(file_name);
  std::uint64_t bytes = 0;
  return file >> bytes ? bytes : kUnlimited;
}

/// A hierarchy of groups: where it is mounted and what its limits are called.
struct Hierarchy {
  fs::path folder;
  const char* limit_file;
};

/// The least limit of a group such as "/a/b", of those that it is in, and of the hierarchy's root,
/// which in a container is the container's own group.
std::uint64_t limit_of_group(const Hierarchy& hierarchy, const fs::path& group) {
  std::uint64_t limit = limit_in(hierarchy.folder / hierarchy.limit_file);
  fs::path folder = hierarchy.folder;
  for (const fs::path& part : group.relative_path())
    limit = std::min(limit, limit_in((folder /= part) / hierarchy.limit_file));
  return limit;
}

/// The group that a line of /proc/self/cgroup names, "0::/a/b" (version 2) or "4:memory:/a/b".
std::optional<fs::path> group_in(const std::string& line, bool version_2) {
  const auto first = line.find(':'), second = line.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) return std::nullopt;
  std::string controllers = line.substr(first, second - first + 1);  // "::" or ":cpu,memory:"
  std::replace(controllers.begin(), controllers.end(), ',', ':');
  const bool wanted =
      version_2 ? controllers == "::" : controllers.find(":memory:") != std::string::npos;
  if (!wanted) return std::nullopt;
  return line.substr(second + 1);
}

}  // namespace

std::uint64_t control_group_limit_bytes(const fs::path& root) {
  const fs::path mounts = root / "sys/fs/cgroup";
  const Hierarchy version_1{mounts / "memory", "memory.limit_in_bytes"};
  const Hierarchy version_2{mounts, "memory.max"};
  std::uint64_t limit = std::min(limit_of_group(version_1, ""), limit_of_group(version_2, ""));
  std::ifstream membership(root / "proc/self/cgroup");
  for (std::string line; std::getline(membership, line);) {
    if (const auto group = group_in(line, false))
      limit = std::min(limit, limit_of_group(version_1, *group));
    if (const auto group = group_in(line, true))
      limit = std::min(limit, limit_of_group(version_2, *group));
  }
  return limit;
}

std::uint64_t memory_size_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long page_bytes = sysconf(_SC_PAGESIZE);
  const std::uint64_t physical =
      pages > 0 && page_bytes > 0
          ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page_bytes)
          : kUnlimited;
  return std::min(physical, control_group_limit_bytes());
}

std::uint64_t default_memory_limit_bytes() { return memory_size_bytes() / 4 * 3; }

}  // namespace glare
